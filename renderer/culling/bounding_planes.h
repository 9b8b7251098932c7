#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.h"
#include "shared/frame_blocks.shared.h"

namespace timeshade {

struct ViewPlan;

/// The sides of the scene's bounding box that a light shines on from within: what lies in them has nothing behind it
/// that its shadow could fall on. A flat ground, most of the time.
class BoundingPlanes {
  public:
    /// `extent`: all vertices at both ends of the shutter, like `block` and `light` relative to the plan's origin.
    BoundingPlanes(const Bounds& extent, const shared::FrameBlock& block, const ViewPlan& light);

    /// Does the triangle lie in one of them all through the shutter? Nothing that is seen is then behind it by more
    /// than half of what the definition of a shadow leaves out (SEGMENT_NEAREST), rounding counted. `positionTexels`:
    /// MeshTexels::positions.
    bool holds(const std::vector<glm::vec4>& positionTexels, std::uint32_t id) const;

  private:
    struct Side {
        int axis;
        float low, high;  ///< coordinates that count as lying in it
    };
    std::vector<Side> sides_;
};

}  // namespace timeshade
