#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "plan/view_plan.h"
#include "shared/swept_bounds.shared.h"

namespace timeshade {

/// A moving triangle as a view sees it: view coordinates (X, Y, Z), linear in u between the two ends of the shutter.
struct ViewTriangle {
    glm::vec3 open[3];
    glm::vec3 close[3];
    bool doubleSided = false;
};

/// Triangle `id` of a mesh's uploaded texels (MeshTexels::positions): computed from the very numbers that the GPU sees,
/// in float as it does.
ViewTriangle viewTriangle(const shared::ViewBlock& block, const std::vector<glm::vec4>& positionTexels,
                          std::uint32_t id);

/// Where in the image the triangle may be seen during the shutter.
shared::SweptBounds boundsOf(const ViewPlan& view, const ViewTriangle& triangle);

/// Do the bounds meet the image at all? With a slack far above the rounding of a projection.
bool meetsImage(const shared::SweptBounds& bounds);

}  // namespace timeshade
