#include "plan/light_motion.h"

#include <algorithm>
#include <cmath>

#include "plan/view_triangle.h"

namespace timeshade {

namespace {

bool standsStill(const ViewTriangle& t) {
    return t.open[0] == t.close[0] && t.open[1] == t.close[1] && t.open[2] == t.close[2];
}

float nearest(const ViewTriangle& t) {
    return std::min({t.open[0].z, t.open[1].z, t.open[2].z, t.close[0].z, t.close[1].z, t.close[2].z});
}

/// Do the vertices take different ways? By more than the rounding of the view's coordinates.
bool bends(const ViewTriangle& t) {
    float size = 0.0f, difference = 0.0f;
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 other = (t.close[i] - t.open[i]) - (t.close[0] - t.open[0]);
        for (int axis = 0; axis < 3; ++axis) {
            size = std::max({size, std::abs(t.open[i][axis]), std::abs(t.close[i][axis])});
            difference = std::max(difference, std::abs(other[axis]));
        }
    }
    return difference > 1e-5f * size;
}

} // namespace

LightMotion classifyForLight(const FramePlan& plan) {
    const ViewPlan& light = plan.light;
    const std::vector<glm::vec4>& texels = plan.texels->positions;
    LightMotion motion;
    const auto count = static_cast<std::uint32_t>(texels.size() / TRIANGLE_POSITION_TEXELS);
    for (std::uint32_t id = 0; id < count; ++id) {
        const ViewTriangle triangle = viewTriangle(light.block, texels, id);
        if (!meetsImage(boundsOf(light, triangle))) continue;
        if (standsStill(triangle)) {
            motion.still.push_back(id);
        } else if (light.projection == Projection::Perspective && nearest(triangle) <= light.block.nearDistance) {
            motion.nearPlane.push_back(id);
        } else {
            motion.moving.push_back(id);
            if (bends(triangle)) ++motion.bending;
        }
    }
    return motion;
}

} // namespace timeshade
