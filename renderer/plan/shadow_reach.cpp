#include "plan/shadow_reach.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace timeshade {

namespace {

/// The five planes of a view's frustum (0 < X < Z, 0 < Y < Z, Z > 0) as linear functions that are positive inside.
std::array<float, 5> planes(const glm::vec3& v) { return {v.x, v.z - v.x, v.y, v.z - v.y, v.z}; }

float largest(const glm::vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace

// The points behind a vertex p, seen from the light l, are p + t (p - l) with t >= 0. A plane's function f is linear,
// so they are all outside if f(p) < 0 and f(p) - f(l) < 0. Since p and l (or the direction of a
// sun) are linear in u and a triangle is the convex hull of its vertices, it suffices to test three vertices at both
// ends of the shutter.
bool shadowMayBeSeen(const FrameViews& views, const ViewTriangle& inCamera) {
    if (views.camera.turns || views.camera.projection != Projection::Perspective) return true;
    bool outside[5] = {true, true, true, true, true};
    const auto mayBeSeen = [&] {
        return std::none_of(std::begin(outside), std::end(outside), [](bool yes) { return yes; });
    };
    // Early out: most triangles are inside the frustum themselves.
    for (const bool close : {false, true}) {
        for (const glm::vec3& vertex : close ? inCamera.close : inCamera.open) {
            const float slack = 1e-4f * largest(vertex);
            const std::array<float, 5> here = planes(vertex);
            for (std::size_t i = 0; i < 5; ++i) outside[i] = outside[i] && here[i] < -slack;
            if (mayBeSeen()) return true;
        }
    }
    const bool directional = views.block.lightDirection.w != 0.0f;
    for (const bool close : {false, true}) {
        const glm::mat4& viewFromWorld =
            close ? views.camera.block.viewFromWorldClose : views.camera.block.viewFromWorldOpen;
        const glm::vec3 light(
            viewFromWorld *
            glm::vec4(glm::vec3(close ? views.block.lightPositionClose : views.block.lightPositionOpen), 1.0f));
        const glm::vec3 direction =
            glm::mat3(viewFromWorld) * glm::vec3(close ? views.block.lightDirectionClose : views.block.lightDirection);
        for (const glm::vec3& vertex : close ? inCamera.close : inCamera.open) {
            const glm::vec3 onwards = directional ? direction : vertex - light;
            const float onwardsSlack = 1e-4f * (directional ? largest(direction) : largest(vertex) + largest(light));
            const std::array<float, 5> change = planes(onwards);
            for (std::size_t i = 0; i < 5; ++i) outside[i] = outside[i] && change[i] < -onwardsSlack;
        }
    }
    return mayBeSeen();
}

}  // namespace timeshade
