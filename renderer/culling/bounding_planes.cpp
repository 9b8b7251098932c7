#include "culling/bounding_planes.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "plan/view_plan.h"
#include "shared/segment_triangle.shared.h"

namespace timeshade {

BoundingPlanes::BoundingPlanes(const Bounds& extent, const shared::FrameBlock& block, const ViewPlan& light) {
    if (extent.empty()) return;
    const bool directional = block.lightDirection.w != 0.0f;
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        largest = std::max({largest, std::abs(extent.low[axis]), std::abs(extent.high[axis])});
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool above : {false, true}) {
            const double side = above ? extent.high[axis] : extent.low[axis], inwards = above ? -1.0 : 1.0;
            // The distance from the side to the light, which is the least that any shadow segment from it travels.
            double away = -static_cast<double>(block.lightDirection[axis]) *
                          static_cast<double>(light.block.farDistance) * inwards;
            if (!directional)
                away = std::min((static_cast<double>(block.lightPositionOpen[axis]) - side) * inwards,
                                (static_cast<double>(block.lightPositionClose[axis]) - side) * inwards);
            // A receiver is at most `rounding` beyond the side, and a triangle that lies in it at most `room` before
            // it: their distance is less than the part of the segment in which no caster counts.
            const double rounding = 5e-7 * largest,
                         room = 0.5 * static_cast<double>(SEGMENT_NEAREST) * away - 2.0 * rounding;
            if (room > rounding)
                sides_.push_back({axis, static_cast<float>(side - room), static_cast<float>(side + room)});
        }
    }
}

bool BoundingPlanes::holds(const std::vector<glm::vec4>& positionTexels, std::uint32_t id) const {
    CHECK_LT(std::size_t{id} * TRIANGLE_POSITION_TEXELS, positionTexels.size());
    const float* corners = &positionTexels[std::size_t{id} * TRIANGLE_POSITION_TEXELS].x;
    constexpr int coordinates = 18;  // three vertices at both ends
    return std::any_of(sides_.begin(), sides_.end(), [&](const Side& side) {
        for (int i = side.axis; i < coordinates; i += 3)
            if (!(corners[i] >= side.low && corners[i] <= side.high)) return false;
        return true;
    });
}

}  // namespace timeshade
