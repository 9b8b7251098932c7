#include "plan/triangle_motion.h"

#include <algorithm>
#include <cmath>

#include "plan/shadow_reach.h"
#include "plan/view_triangle.h"
#include "shared/swept_bounds.shared.h"

namespace timeshade {

namespace {

float sizeOf(const glm::vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// The sign of dot(vertex, cross(edge, edge)), a cubic in u, from its Bernstein coefficients. Differences of vertices
/// are formed first, which keeps precision for small triangles far away.
Facing facingOf(const ViewTriangle& t, Projection projection) {
    const glm::vec3 a1 = t.open[1] - t.open[0], a2 = t.open[2] - t.open[0], b1 = t.close[1] - t.close[0],
                    b2 = t.close[2] - t.close[0];
    const bool flat = projection == Projection::Orthographic;
    const glm::vec3 a = flat ? glm::vec3(0.0f, 0.0f, 1.0f) : t.open[0], b = flat ? a : t.close[0];
    const glm::vec3 normalOpen = glm::cross(a1, a2), normalClose = glm::cross(b1, b2),
                    between = glm::cross(a1, b2) + glm::cross(b1, a2);
    const float first = glm::dot(a, normalOpen), second = glm::dot(b, normalOpen) + glm::dot(a, between);
    const float third = glm::dot(b, between) + glm::dot(a, normalClose), last = glm::dot(b, normalClose);
    // Bound on the rounding error: each coordinate is rounded in proportion to its magnitude (`place`).
    const float length = sizeOf(a1) + sizeOf(a2) + sizeOf(b1) + sizeOf(b2),
                place = sizeOf(t.open[0]) + sizeOf(t.close[0]) + length;
    const float slack = 1.5e-7f * place * length * (sizeOf(a) + sizeOf(b));
    if (first < -slack && second < -slack && third < -slack && last < -slack) return Facing::Away;
    if (first > slack && second > slack && third > slack && last > slack) return Facing::Towards;
    return Facing::Unsure;
}

/// Image bounds of the triangle at u = 0, and of its path during the shutter (boundsOf()).
struct OpenAndSwept {
    shared::SweptBounds open, swept;
};

/// sweptBoundsPerspective for both at once: the extremes at u = 0 are reused for the path.
OpenAndSwept openAndSwept(const ViewTriangle& t, float nearDistance) {
    shared::HomogeneousExtremes extremes = shared::noHomogeneousPoints();
    for (const glm::vec3& p : t.open) extremes = shared::addHomogeneousPoint(extremes, p);
    OpenAndSwept bounds{shared::boundsOfExtremes(extremes), {}};
    for (const glm::vec3& p : t.close) extremes = shared::addHomogeneousPoint(extremes, p);
    bounds.swept = shared::boundsOfExtremes(extremes);
    const float farthestOpen = std::max({t.open[0].z, t.open[1].z, t.open[2].z});
    const float farthest = std::max({farthestOpen, t.close[0].z, t.close[1].z, t.close[2].z});
    const auto hide = [](shared::SweptBounds& b) {
        b.low = glm::vec2(1.0f);
        b.high = glm::vec2(0.0f);
    };
    if (!(farthestOpen > nearDistance)) hide(bounds.open);
    if (!(farthest > nearDistance)) hide(bounds.swept);
    return bounds;
}

OpenAndSwept openAndSwept(const ViewPlan& view, const ViewTriangle& t) {
    if (!view.turns && view.projection == Projection::Perspective) return openAndSwept(t, view.block.nearDistance);
    ViewTriangle held = t;
    for (int i = 0; i < 3; ++i) held.close[i] = t.open[i];
    return {boundsOf(view, held), boundsOf(view, t)};
}

/// Approximate side, in pixels, of the square that covers the triangle during one stratum.
float squareSide(const ViewPlan& view, const OpenAndSwept& bounds, std::uint32_t strata) {
    const shared::SweptBounds &own = bounds.open, &swept = bounds.swept;
    const glm::vec2 extent = (own.high - own.low) * view.block.size;
    const glm::vec2 whole = (swept.high - swept.low) * view.block.size;
    const glm::vec2 side = extent + (whole - extent) / static_cast<float>(strata);
    return std::max(side.x, side.y);
}

bool fitsPoint(const ViewPlan& view, const OpenAndSwept& both, std::uint32_t strata) {
    // A point covers more pixels than a long triangle needs; a rectangle costs four vertices and set-up of two
    // triangles.
    const float largestSmallSide = 16.0f;
    const shared::SweptBounds& bounds = both.swept;
    const glm::vec2 whole = (bounds.high - bounds.low) * view.block.size;
    return bounds.crosses == 0u && std::max(whole.x, whole.y) < static_cast<float>(maximumPointSide - 2) &&
           squareSide(view, both, strata) <= largestSmallSide;
}

float nearest(const ViewTriangle& t) {
    return std::min({t.open[0].z, t.open[1].z, t.open[2].z, t.close[0].z, t.close[1].z, t.close[2].z});
}

Reach reachOf(const shared::SweptBounds& bounds) {
    if (!meetsImage(bounds)) return Reach::Outside;
    const bool inside = bounds.crosses == 0u && glm::all(glm::greaterThanEqual(bounds.low, glm::vec2(0.0f))) &&
                        glm::all(glm::lessThanEqual(bounds.high, glm::vec2(1.0f)));
    return inside ? Reach::Inside : Reach::Crossing;
}

ViewMotion motionIn(const ViewPlan& view, const ViewTriangle& t, const OpenAndSwept& bounds, std::uint32_t strata) {
    ViewMotion motion;
    motion.moves = view.turns || t.open[0] != t.close[0] || t.open[1] != t.close[1] || t.open[2] != t.close[2];
    motion.facing = facingOf(t, view.projection);
    motion.reach = reachOf(bounds.swept);
    motion.small = motion.reach != Reach::Outside && fitsPoint(view, bounds, strata);
    motion.reachesNearPlane = view.projection == Projection::Perspective && nearest(t) <= view.block.nearDistance;
    return motion;
}

/// Whether the vertices have different displacements, by more than the rounding of view coordinates.
bool nonTranslating(const ViewTriangle& t) {
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

bool movesInWorld(const glm::vec4* texels) {
    const float* open = &texels[0].x;
    return !std::equal(open, open + 9, open + 9);
}

}  // namespace

TriangleMotion motionOf(const std::vector<glm::vec4>& positionTexels, std::uint32_t id, const FrameViews& views,
                        shared::SweptBounds& inMap) {
    const ViewTriangle inCamera = viewTriangle(views.camera.block, positionTexels, id);
    const ViewTriangle inLight = viewTriangle(views.light.block, positionTexels, id);
    TriangleMotion motion;
    motion.movesInWorld = movesInWorld(positionTexels.data() + std::size_t{id} * TRIANGLE_POSITION_TEXELS);
    motion.doubleSided = inCamera.doubleSided;
    motion.camera = motionIn(views.camera, inCamera, openAndSwept(views.camera, inCamera), views.block.strata);
    const OpenAndSwept lightBounds = openAndSwept(views.light, inLight);
    inMap = lightBounds.swept;
    motion.light = motionIn(views.light, inLight, lightBounds, views.block.strata);
    motion.nonTranslating = motion.light.moves && nonTranslating(inLight);
    motion.shadowMayBeSeen = shadowMayBeSeen(views, inCamera);
    return motion;
}

void listTriangles(ViewPlan& view, const std::vector<TriangleMotion>& triangles, ViewMotion TriangleMotion::*part,
                   const ListRules& rules) {
    view.staticTriangles = view.dynamicTriangles = {};
    view.outsideTriangles = view.facingAwayTriangles = view.unseenTriangles = 0;
    for (std::uint32_t id = 0; id < triangles.size(); ++id) {
        const TriangleMotion& triangle = triangles[id];
        const ViewMotion& motion = triangle.*part;
        if (rules.dropFacingAway && !triangle.doubleSided && motion.facing == Facing::Away) {
            ++view.facingAwayTriangles;
        } else if (motion.reach == Reach::Outside) {
            ++view.outsideTriangles;
        } else if (rules.dropUnseenShadows && motion.moves && !triangle.shadowMayBeSeen) {
            ++view.unseenTriangles;
        } else {
            TriangleLists& lists = motion.moves || rules.allMove ? view.dynamicTriangles : view.staticTriangles;
            (motion.small ? lists.small : lists.large).push_back(id);
        }
    }
}

}  // namespace timeshade
