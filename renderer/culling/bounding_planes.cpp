#include "culling/bounding_planes.h"

#include <algorithm>

#include "core/check.h"
#include "plan/view_plan.h"

namespace timeshade {

BoundingPlanes::BoundingPlanes(const Bounds& extent, const shared::FrameBlock& block, const ViewPlan& light) {
    if (extent.empty()) return;
    const bool directional = block.lightDirection.w != 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool above : {false, true}) {
            const double side = above ? extent.high[axis] : extent.low[axis], inwards = above ? -1.0 : 1.0;
            // How far the light stays from the side.
            const float against = inwards * static_cast<double>(block.lightDirection[axis]) >
                                          inwards * static_cast<double>(block.lightDirectionClose[axis])
                                      ? block.lightDirection[axis]
                                      : block.lightDirectionClose[axis];
            double away = -static_cast<double>(against) * static_cast<double>(light.block.farDistance) * inwards;
            if (!directional)
                away = std::min((static_cast<double>(block.lightPositionOpen[axis]) - side) * inwards,
                                (static_cast<double>(block.lightPositionClose[axis]) - side) * inwards);
            // No receiver lies beyond the side, and light comes from within: a segment that begins in it or before it
            // never meets a triangle that lies in it.
            if (away > 0.0) sides_.push_back({axis, static_cast<float>(side)});
        }
    }
}

bool BoundingPlanes::holds(const std::vector<glm::vec4>& positionTexels, std::uint32_t id) const {
    CHECK_LT(std::size_t{id} * TRIANGLE_POSITION_TEXELS, positionTexels.size());
    const float* corners = &positionTexels[std::size_t{id} * TRIANGLE_POSITION_TEXELS].x;
    constexpr int coordinates = 18;  // three vertices at both ends
    return std::any_of(sides_.begin(), sides_.end(), [&](const Side& side) {
        for (int i = side.axis; i < coordinates; i += 3)
            if (corners[i] != side.place) return false;
        return true;
    });
}

}  // namespace timeshade
