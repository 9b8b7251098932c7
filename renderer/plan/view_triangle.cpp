#include "plan/view_triangle.h"

#include "core/check.h"

namespace timeshade {

ViewTriangle viewTriangle(const shared::ViewBlock& block, const std::vector<glm::vec4>& positionTexels,
                          std::uint32_t id) {
    CHECK_LT(std::size_t{id} * TRIANGLE_POSITION_TEXELS, positionTexels.size());
    const glm::vec4* t = positionTexels.data() + std::size_t{id} * TRIANGLE_POSITION_TEXELS;
    const glm::vec3 open[3] = {glm::vec3(t[0]), {t[0].w, t[1].x, t[1].y}, {t[1].z, t[1].w, t[2].x}};
    const glm::vec3 close[3] = {{t[2].y, t[2].z, t[2].w}, glm::vec3(t[3]), {t[3].w, t[4].x, t[4].y}};
    ViewTriangle triangle{};
    for (int i = 0; i < 3; ++i) {
        triangle.open[i] = glm::vec3(block.viewFromWorldOpen * glm::vec4(open[i], 1.0f));
        triangle.close[i] = glm::vec3(block.viewFromWorldClose * glm::vec4(close[i], 1.0f));
    }
    triangle.doubleSided = t[4].z != 0.0f;
    return triangle;
}

shared::SweptBounds boundsOf(const ViewPlan& view, const ViewTriangle& t) {
    if (view.turns)
        return shared::sweptBoundsTurning(t.open[0], t.open[1], t.open[2], t.close[0], t.close[1], t.close[2],
                                          view.block.raysOpen, view.block.raysClose);
    if (view.projection == Projection::Orthographic)
        return shared::sweptBoundsOrthographic(t.open[0], t.open[1], t.open[2], t.close[0], t.close[1], t.close[2]);
    return shared::sweptBoundsPerspective(t.open[0], t.open[1], t.open[2], t.close[0], t.close[1], t.close[2],
                                          view.block.nearDistance);
}

shared::SweptBounds boundsOf(const ViewPlan& view, const ViewTriangle& t, float u0, float u1) {
    ViewTriangle part = t;
    for (int i = 0; i < 3; ++i) {
        part.open[i] = glm::mix(t.open[i], t.close[i], u0);
        part.close[i] = glm::mix(t.open[i], t.close[i], u1);
    }
    if (!view.turns) return boundsOf(view, part);
    const auto raysAt = [&](float u) { return view.block.raysOpen * (1.0f - u) + view.block.raysClose * u; };
    return shared::sweptBoundsTurning(part.open[0], part.open[1], part.open[2], part.close[0], part.close[1],
                                      part.close[2], raysAt(u0), raysAt(u1));
}

bool meetsImage(const shared::SweptBounds& bounds) {
    const float slack = 1e-3f;  // share of the image
    return bounds.low.x <= 1.0f + slack && bounds.low.y <= 1.0f + slack && bounds.high.x >= -slack &&
           bounds.high.y >= -slack && bounds.low.x <= bounds.high.x;
}

}  // namespace timeshade
