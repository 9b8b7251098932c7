#include "techniques/history/map_raster.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "techniques/history/seen_body.h"

namespace timeshade {

namespace {

constexpr double rightAngle = 1.57079632679489662;

/// (x, y) of a homography's image.
glm::dvec2 apply(const glm::dmat3& map, const glm::dvec2& p) {
    const glm::dvec3 h = map * glm::dvec3(p, 1.0);
    return glm::dvec2(h) / h.z;
}

/// Corners around all that the light reaches: a square, or a polygon around a spot's cone.
std::vector<glm::dvec2> reachOf(Projection projection) {
    if (projection == Projection::Orthographic) return {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    std::vector<glm::dvec2> corners;
    constexpr int count = 64;
    for (int i = 0; i < count; ++i) {
        const double angle = 4.0 * rightAngle * (i + 0.5) / count, radius = 0.5 / std::cos(2.0 * rightAngle / count);
        corners.push_back(glm::dvec2(0.5) + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return corners;
}

/// Wimmer et al. 2004 in the light's map plane: the weight grows along the way that the camera looks, so that what is
/// near keeps more texels. The distance of the warp's centre from the near end is n = (zn + sqrt(zn zf)) / sin(angle
/// between the views), which goes to infinity, and the warp to nothing, as they become parallel.
glm::dmat3 perspectiveWarp(const FramePlan& plan, const std::vector<glm::dvec3>& body,
                           const std::vector<glm::dvec2>& corners) {
    const ViewEnd& camera = plan.camera.open;
    const glm::dvec3 direction = glm::normalize(camera.corner + 0.5 * (camera.right + camera.up));
    glm::dvec3 centre(0.0);
    double nearest = 1e300, farthest = 0.0;
    for (const glm::dvec3& p : body) {
        centre += p / static_cast<double>(body.size());
        nearest = std::min(nearest, glm::dot(p - camera.eye, direction));
        farthest = std::max(farthest, glm::dot(p - camera.eye, direction));
    }
    nearest = std::max(nearest, 1e-3 * farthest);
    const bool directional = plan.lightOpen.kind == LightKind::Directional;
    const glm::dvec3 ray =
        directional ? -plan.lightAxes[2] : glm::normalize(centre - (plan.lightOpen.position - plan.origin));
    const double sine = glm::length(glm::cross(direction, ray));
    if (sine < 1e-3) return glm::dmat3(1.0);
    // A short step, so that it stays before a spot that looks the camera in the face.
    const double step = 1e-3 * farthest;
    const glm::dvec2 way = (onMapPlane(plan.light, centre + direction * step) - onMapPlane(plan.light, centre)) / step;
    const double length = glm::length(way);
    if (!(length > 0.0)) return glm::dmat3(1.0);
    // way is how far a unit of the view's direction goes in the plane; across the light it is 1 / sine of that.
    const double n = length / sine * (nearest + std::sqrt(nearest * farthest)) / sine;
    const glm::dvec2 y = way / length;
    double first = 1e300;
    for (const glm::dvec2& p : corners) first = std::min(first, glm::dot(p, y));
    glm::dmat3 warp(1.0);
    warp[0].z = y.x / n;
    warp[1].z = y.y / n;
    warp[2].z = 1.0 - first / n;
    return warp;
}

/// Turns by the angle, then brings the corners into the unit square with a margin; texels stay square where asked.
glm::dmat3 fitted(const std::vector<glm::dvec2>& corners, double angle, bool square, double margin) {
    const double c = std::cos(angle), s = std::sin(angle);
    const glm::dmat2 turn(c, s, -s, c);
    glm::dvec2 low(1e300), high(-1e300);
    for (const glm::dvec2& p : corners) {
        low = glm::min(low, turn * p);
        high = glm::max(high, turn * p);
    }
    glm::dvec2 extent = high - low;
    if (square) extent = glm::dvec2(std::max(extent.x, extent.y));
    const glm::dvec2 scale = (1.0 - 2.0 * margin) / glm::max(extent, glm::dvec2(1e-9));
    const glm::dmat2 linear(turn[0] * scale, turn[1] * scale);
    const glm::dvec2 origin = glm::dvec2(0.5) - 0.5 * (low + high) * scale;
    return {glm::dvec3(linear[0], 0.0), glm::dvec3(linear[1], 0.0), glm::dvec3(origin, 1.0)};
}

glm::dmat3 shifted(const glm::dvec2& by) { return {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {by, 1.0}}; }

}  // namespace

double radicalInverse(std::uint32_t base, std::uint32_t index) {
    double value = 0.0, digit = 1.0;
    for (; index > 0; index /= base) {
        digit /= base;
        value += digit * (index % base);
    }
    return value;
}

glm::dmat3 mapRaster(const FramePlan& plan, MapFit fit, MapJitter jitter, std::uint32_t index) {
    if (jitter == MapJitter::None && fit == MapFit::Light) return glm::dmat3(1.0);
    const glm::dvec2 texels = 1.0 / plan.request.mapSize.sides();
    const double texel = std::max(texels.x, texels.y);
    const double angle = jitter == MapJitter::ShiftAndTurn ? rightAngle * radicalInverse(5, index + 1) : 0.0;
    const glm::dvec2 shift =
        jitter == MapJitter::None
            ? glm::dvec2(0.0)
            : (glm::dvec2(radicalInverse(2, index + 1), radicalInverse(3, index + 1)) - 0.5) * texels;
    std::vector<glm::dvec3> body;
    // What a camera sees on its way is more than what it sees at both ends.
    if (fit != MapFit::Light && !plan.motion.cameraMoves) body = seenBody(plan, plan.camera.open);
    // A texel's room for the shift.
    if (body.size() < 3 || plan.motion.lightMoves)
        return shifted(shift) * fitted(reachOf(plan.light.projection), angle, true, texel);
    std::vector<glm::dvec2> corners;
    for (const glm::dvec3& p : body) corners.push_back(onMapPlane(plan.light, p));
    const glm::dmat3 warp = fit == MapFit::Warped ? perspectiveWarp(plan, body, corners) : glm::dmat3(1.0);
    for (glm::dvec2& corner : corners) corner = apply(warp, corner);
    // Two texels beside what is seen, so that a filter finds something there.
    glm::dmat3 map = shifted(shift) * fitted(corners, angle, false, 3.0 * texel) * warp;
    const glm::dmat3 planeFromMap = glm::inverse(map);
    double most = 0.0;
    for (const glm::dvec2 corner :
         {glm::dvec2(0.0, 0.0), glm::dvec2(1.0, 0.0), glm::dvec2(0.0, 1.0), glm::dvec2(1.0, 1.0)}) {
        const double inverseWeight = (planeFromMap * glm::dvec3(corner, 1.0)).z;
        if (!(inverseWeight > 1e-6)) return shifted(shift) * fitted(reachOf(plan.light.projection), angle, true, texel);
        most = std::max(most, inverseWeight);
    }
    return map * most;
}

}  // namespace timeshade
