#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.h"
#include "shared/frame_blocks.shared.h"

namespace timeshade {

struct ViewPlan;

/// The sides of the scene's bounding box whose inner side faces the light. A triangle that lies in one of them has no
/// receiver behind it and need not cast a shadow. Mostly this is a flat ground.
class BoundingPlanes {
  public:
    /// `extent`: all vertices at both ends of the shutter, like `block` and `light` relative to the plan's origin.
    BoundingPlanes(const Bounds& extent, const shared::FrameBlock& block, const ViewPlan& light);

    /// Whether the triangle lies in one of the sides during the whole shutter, to the last bit. No receiver is then
    /// behind it.
    /// `positionTexels`: MeshTexels::positions.
    bool holds(const std::vector<glm::vec4>& positionTexels, std::uint32_t id) const;

  private:
    struct Side {
        int axis;
        float place;  ///< world units relative to the plan's origin
    };
    std::vector<Side> sides_;
};

}  // namespace timeshade
