#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "plan/triangle_motion.h"

namespace timeshade {

struct MeshTexels;

/// Numbers that stand for what stands still. Two frames with the same number, of whatever planner, have the same of it,
/// to the last bit, so what was drawn of it for one serves the other. 0: nothing may be kept.
struct StaticVersions {
    std::uint64_t casters = 0;  ///< the light's view and the triangles that stand still in it
    std::uint64_t samples = 0;  ///< the camera's view and samples, and the triangles that stand still before it
    std::uint64_t lit = 0;      ///< both, and the light
};

/// What every triangle does, decided anew only for those whose numbers are others than in the frame before.
class MotionClassifier {
  public:
    struct Motion {
        std::shared_ptr<const std::vector<TriangleMotion>> triangles;
        std::shared_ptr<const std::vector<shared::SweptBounds>> inMap;  ///< where in the light's map each may be
        StaticVersions versions;
        std::size_t reclassified = 0;  ///< triangles
    };
    Motion update(const std::shared_ptr<const MeshTexels>& texels, const FrameViews& views);

  private:
    std::shared_ptr<const MeshTexels> texels_;
    shared::ViewBlock camera_{}, light_{};
    shared::FrameBlock block_{};
    Motion last_;
};

}  // namespace timeshade
