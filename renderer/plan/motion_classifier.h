#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "plan/triangle_motion.h"

namespace timeshade {

struct MeshTexels;

/// Version numbers of the static parts of a frame, for use in cache keys. Two frames with the same number, even from
/// different planners, have bitwise equal static parts, so a cached result is valid for both. 0: must not be cached.
struct StaticVersions {
    std::uint64_t casters = 0;  ///< the light's view and its static triangles
    std::uint64_t samples = 0;  ///< the camera's view and sample pattern, and its static triangles
    std::uint64_t lit = 0;      ///< both, and the light: visibility of static receivers by static casters
    std::uint64_t shading = 0;  ///< all that, and the normals of static receivers: their colours
};

/// Classifies the motion of every triangle. Results of the previous frame are reused for triangles whose positions and
/// views have not changed.
class MotionClassifier {
  public:
    struct Motion {
        std::shared_ptr<const std::vector<TriangleMotion>> triangles;
        std::shared_ptr<const std::vector<shared::SweptBounds>> inMap;  ///< bounds in the shadow map
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
