#include "passes/map_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "passes/seen_body.h"

namespace timeshade {

namespace {

constexpr double rightAngle = 1.57079632679489662;
/// Between the weights of a map's corners. Farther apart a texel at one corner would cover a millionth of one at
/// another.
constexpr double leastWeightRatio = 1e-3;

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

/// A warp of the map plane: its weight is 1 + slope . (p - first), first being the nearest of what is covered.
struct Warp {
    glm::dvec2 slope;
    double first;  ///< slope . the nearest
    glm::dmat3 matrix(double strength) const {
        glm::dmat3 warp(1.0);
        warp[0].z = strength * slope.x;
        warp[1].z = strength * slope.y;
        warp[2].z = 1.0 - strength * first;
        return warp;
    }
};

/// Wimmer et al. 2004 in the light's map plane: the weight grows along the way that the camera looks, so that what is
/// near keeps more texels. The distance of the warp's centre from the near end is n = (zn + sqrt(zn zf)) / sin(angle
/// between the views), which goes to infinity, and the warp to nothing, as they become parallel; then there is none.
std::optional<Warp> perspectiveWarp(const FramePlan& plan, const std::vector<glm::dvec3>& body,
                                    const std::vector<glm::dvec2>& corners) {
    const ViewEnd &open = plan.camera.open, &close = plan.camera.close;
    const glm::dvec3 eye = 0.5 * (open.eye + close.eye), right = 0.5 * (open.right + close.right),
                     up = 0.5 * (open.up + close.up), corner = 0.5 * (open.corner + close.corner);
    const glm::dvec3 direction = glm::normalize(corner + 0.5 * (right + up));
    glm::dvec3 centre(0.0);
    double farthest = 0.0;
    for (const glm::dvec3& p : body) {
        centre += p / static_cast<double>(body.size());
        farthest = std::max(farthest, glm::dot(p - eye, direction));
    }
    // The body begins at a camera that stands amid the scene: what it sees there begins farther on.
    const double nearest = std::clamp(nearestSeen(plan), 1e-3 * farthest, farthest);
    const bool directional = plan.lightOpen.kind == LightKind::Directional;
    const glm::dvec3 light = 0.5 * (plan.lightOpen.position + plan.lightClose.position) - plan.origin;
    const glm::dvec3 ray = directional ? -plan.lightAxes[2] : glm::normalize(centre - light);
    const double sine = glm::length(glm::cross(direction, ray));
    if (sine < 1e-3) return std::nullopt;
    // A short step, so that it stays before a spot that looks the camera in the face.
    const double step = 1e-3 * farthest;
    const glm::dvec2 way = (onMapPlane(plan.light, centre + direction * step) - onMapPlane(plan.light, centre)) / step;
    const double length = glm::length(way);
    if (!(length > 0.0)) return std::nullopt;
    // way is how far a unit of the view's direction goes in the plane; across the light it is 1 / sine of that.
    const double n = length / sine * (nearest + std::sqrt(nearest * farthest)) / sine;
    Warp warp{way / (length * n), 1e300};
    for (const glm::dvec2& p : corners) warp.first = std::min(warp.first, glm::dot(p, warp.slope));
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

/// The map of corners that are warped first, its weight at least 1 inside; nothing where a corner of the map lies too
/// far towards the warp's horizon, or beyond.
std::optional<glm::dmat3> mapOf(std::vector<glm::dvec2> corners, const glm::dmat3& warp, const MapGrid& grid,
                                double texel) {
    for (glm::dvec2& corner : corners) corner = apply(warp, corner);
    // Two texels beside what is seen, so that a filter finds something there.
    const glm::dmat3 map = shifted(grid.shift) * fitted(corners, grid.angle, false, 3.0 * texel) * warp;
    const glm::dmat3 planeFromMap = glm::inverse(map);
    double least = 1e300, most = 0.0;
    for (const glm::dvec2 corner :
         {glm::dvec2(0.0, 0.0), glm::dvec2(1.0, 0.0), glm::dvec2(0.0, 1.0), glm::dvec2(1.0, 1.0)}) {
        const double inverseWeight = (planeFromMap * glm::dvec3(corner, 1.0)).z;
        least = std::min(least, inverseWeight);
        most = std::max(most, inverseWeight);
    }
    if (!(least > leastWeightRatio * most)) return std::nullopt;
    return map * most;
}

/// The largest share of a warp's strength with which the map stays before the horizon. Without any it does.
double strengthOf(const Warp& warp, const std::vector<glm::dvec2>& corners, const MapGrid& grid, double texel) {
    if (mapOf(corners, warp.matrix(1.0), grid, texel)) return 1.0;
    double possible = 0.0, impossible = 1.0;
    for (int i = 0; i < 24; ++i) {
        const double strength = 0.5 * (possible + impossible);
        (mapOf(corners, warp.matrix(strength), grid, texel) ? possible : impossible) = strength;
    }
    return possible;
}

}  // namespace

FittedMap fitMap(const FramePlan& plan, MapFit fit, const MapGrid& grid) {
    const double texel = 1.0 / plan.request.mapSize.shorterSide();  // the longer side of one
    // A texel's room for the shift.
    const auto whole = [&](const char* why) {
        return FittedMap{shifted(grid.shift) * fitted(reachOf(plan.light.projection), grid.angle, true, texel), 0.0,
                         why};
    };
    if (fit == MapFit::Light) return whole("");
    const bool moves = plan.motion.cameraMoves || plan.motion.lightMoves;
    const std::vector<glm::dvec3> body = moves ? sweptSeenBody(plan) : seenBody(plan, plan.camera.open);
    if (body.size() < 3) return whole("the camera sees nothing that the light reaches, so the map covers all of it");
    std::vector<glm::dvec2> corners;
    if (plan.motion.lightMoves)
        corners = sweptOnMapPlane(plan.light, body);
    else
        for (const glm::dvec3& p : body) corners.push_back(onMapPlane(plan.light, p));
    if (corners.size() < 3)
        return whole("the light moves amid what the camera sees, so the map covers all that the light reaches");
    FittedMap map;
    const std::optional<Warp> warp = fit == MapFit::Warped ? perspectiveWarp(plan, body, corners) : std::nullopt;
    if (warp) map.warp = strengthOf(*warp, corners, grid, texel);
    if (fit == MapFit::Warped && !warp)
        map.shortfall =
            "camera and light look along one line (duelling frusta), so the map is fitted to the camera's view without "
            "a warp";
    map.mapFromPlane = *mapOf(corners, warp ? warp->matrix(map.warp) : glm::dmat3(1.0), grid, texel);
    return map;
}

}  // namespace timeshade
