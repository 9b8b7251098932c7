#include "plan/view_plan.h"

#include <algorithm>
#include <cmath>

#include "plan/view_triangle.h"
#include "shared/swept_bounds.shared.h"

namespace timeshade {

namespace {

/// Columns right, up, corner: maps (s, t, 1) to the ray of the image position (s, t).
glm::dmat3 rayMatrix(const ViewEnd& end) { return {end.right, end.up, end.corner}; }

glm::mat4 viewMatrix(const glm::dmat3& viewFromWorld, const glm::dvec3& eye) {
    glm::dmat4 matrix(viewFromWorld);
    matrix[3] = glm::dvec4(-(viewFromWorld * eye), 1.0);
    return glm::mat4(matrix);
}

bool facesAway(const ViewTriangle& t, Projection projection) {
    const auto vector = [&](glm::vec3 v) { return projection == Projection::Orthographic ? glm::vec3(v.x, v.y, 1.0f) : v; };
    const glm::vec4 facing =
        shared::determinantCoefficients(vector(t.open[0]), vector(t.open[1]), vector(t.open[2]), vector(t.close[0]),
                                        vector(t.close[1]), vector(t.close[2]));
    return glm::all(glm::lessThan(facing, glm::vec4(0.0f)));
}

/// Side of the square that covers the triangle during one stratum, about: its own extent and its share of the way.
float squareSide(const ViewPlan& view, const ViewTriangle& t, const shared::SweptBounds& swept, std::uint32_t strata) {
    ViewTriangle still = t;
    for (int i = 0; i < 3; ++i) still.close[i] = t.open[i];
    const shared::SweptBounds own = boundsOf(view, still);
    const glm::vec2 extent = (own.high - own.low) * view.block.size;
    const glm::vec2 whole = (swept.high - swept.low) * view.block.size;
    const glm::vec2 side = extent + (whole - extent) / static_cast<float>(strata);
    return std::max(side.x, side.y);
}

} // namespace

void finishView(ViewPlan& view, glm::dvec2 size, double nearDistance, double farDistance) {
    shared::ViewBlock& block = view.block;
    block.size = glm::vec2(size);
    block.nearDistance = static_cast<float>(nearDistance);
    block.farDistance = static_cast<float>(farDistance);
    block.raysOpen = block.raysClose = glm::mat4(1.0f);
    view.turns = false;
    if (view.projection == Projection::Orthographic) {
        // corner, right and up span the map itself; depth runs along the third axis.
        const glm::dvec3 direction = glm::normalize(glm::cross(view.open.up, view.open.right));
        const glm::dmat3 viewFromWorld = glm::inverse(glm::dmat3(view.open.right, view.open.up, direction));
        block.viewFromWorldOpen = viewMatrix(viewFromWorld, view.open.eye + view.open.corner);
        block.viewFromWorldClose = viewMatrix(viewFromWorld, view.close.eye + view.close.corner);
        return;
    }
    const glm::dmat3 open = rayMatrix(view.open), close = rayMatrix(view.close);
    double difference = 0.0;
    for (int column = 0; column < 3; ++column) difference = std::max(difference, glm::length(open[column] - close[column]));
    view.turns = difference > 1e-12;
    // A turning view is described in the axes that it has half-way, so that the rays stay near to the identity.
    const glm::dmat3 viewFromWorld = glm::inverse(view.turns ? 0.5 * (open + close) : open);
    block.viewFromWorldOpen = viewMatrix(viewFromWorld, view.open.eye);
    block.viewFromWorldClose = viewMatrix(viewFromWorld, view.close.eye);
    if (view.turns) {
        block.raysOpen = glm::mat4(glm::dmat4(viewFromWorld * open));
        block.raysClose = glm::mat4(glm::dmat4(viewFromWorld * close));
    }
}

void listTriangles(ViewPlan& view, const std::vector<glm::vec4>& positionTexels, const CullingRules& rules) {
    // A square wastes what lies beside a long triangle; a rectangle costs four vertices and two triangles of set-up.
    const float largestSmallSide = 16.0f;
    view.smallTriangles.clear();
    view.largeTriangles.clear();
    view.outsideTriangles = view.facingAwayTriangles = 0;
    const auto count = static_cast<std::uint32_t>(positionTexels.size() / TRIANGLE_POSITION_TEXELS);
    for (std::uint32_t id = 0; id < count; ++id) {
        const ViewTriangle triangle = viewTriangle(view.block, positionTexels, id);
        if (rules.dropFacingAway && !triangle.doubleSided && facesAway(triangle, view.projection)) {
            ++view.facingAwayTriangles;
            continue;
        }
        const shared::SweptBounds bounds = boundsOf(view, triangle);
        if (!meetsImage(bounds)) {
            ++view.outsideTriangles;
            continue;
        }
        const glm::vec2 whole = (bounds.high - bounds.low) * view.block.size;
        const bool fitsPoint = bounds.crosses == 0u && std::max(whole.x, whole.y) < static_cast<float>(maximumPointSide - 2);
        if (fitsPoint && squareSide(view, triangle, bounds, rules.strata) <= largestSmallSide)
            view.smallTriangles.push_back(id);
        else
            view.largeTriangles.push_back(id);
    }
}

} // namespace timeshade
