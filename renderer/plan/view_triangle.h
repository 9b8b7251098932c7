#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "plan/view_plan.h"
#include "shared/swept_bounds.shared.h"

namespace timeshade {

/// A moving triangle in view coordinates (X, Y, Z), linear in u between the two ends of the shutter.
struct ViewTriangle {
    glm::vec3 open[3];
    glm::vec3 close[3];
    bool doubleSided = false;
};

/// Triangle `id` of MeshTexels::positions, transformed in float as on the GPU.
ViewTriangle viewTriangle(const shared::ViewBlock& block, const std::vector<glm::vec4>& positionTexels,
                          std::uint32_t id);

/// Bounds, in image coordinates in [0, 1], of where the triangle may be during the shutter.
shared::SweptBounds boundsOf(const ViewPlan& view, const ViewTriangle& triangle);

/// The same between two times of the shutter.
shared::SweptBounds boundsOf(const ViewPlan& view, const ViewTriangle& triangle, float u0, float u1);

/// Whether the bounds overlap the image, with a slack much larger than the rounding of a projection.
bool meetsImage(const shared::SweptBounds& bounds);

}  // namespace timeshade
