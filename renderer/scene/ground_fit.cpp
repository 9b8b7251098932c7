#include "scene/ground_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace timeshade {

namespace {

/// Shadows that are longer than so many diagonals of the bounds are cut there.
constexpr double farthestShadow = 2.0;
constexpr double farthestSeen = 0.5;
/// Of a spot's map the ground takes nothing, and its light may be placed lower; a sun's map is fitted to all of it.
constexpr double spotMargin = 2.0, sunMargin = 1.25;
/// Vertices that are deformed to look for the lowest point: of large models fewer instants.
constexpr std::size_t mostVertices = 8'000'000;

/// An upright rectangle of the ground, x and z.
struct Area {
    glm::dvec2 low{1e300}, high{-1e300};
    void add(const glm::dvec2& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

glm::dvec2 flat(const glm::dvec3& point) { return {point.x, point.z}; }

glm::dvec3 cornerOf(const Bounds& bounds, int index) {
    return {index & 1 ? bounds.high.x : bounds.low.x, index & 2 ? bounds.high.y : bounds.low.y,
            index & 4 ? bounds.high.z : bounds.low.z};
}

/// Calls `take` with times of the clip, both ends included; with 0 alone where nothing moves.
void atTimes(const Scene& scene, std::size_t count, const std::function<void(double)>& take) {
    const double duration = scene.duration();
    if (!(duration > 0.0)) return take(0.0);
    for (std::size_t i = 0; i <= count; ++i)
        take(duration * static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(count, 1)));
}

/// The box, and where the light throws its shadow on the plane at its own lowest height, at any time.
Area areaWithShadow(const Scene& scene, const Bounds& box, double diagonals = farthestShadow) {
    Area area;
    const double farthest = diagonals * box.diagonal();
    for (int i = 0; i < 8; ++i) area.add(flat(cornerOf(box, i)));
    atTimes(scene, 16, [&](double seconds) {
        const LightPose light = scene.light(seconds);
        const bool spot = light.kind == LightKind::Spot;
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 corner = cornerOf(box, i), away = spot ? corner - light.position : -light.axes[2];
            if (!(away.y < 0.0)) continue;
            glm::dvec2 path = flat(away) * ((corner.y - box.low.y) / -away.y);
            const double length = glm::length(path);
            if (!(length <= farthest)) path *= std::isfinite(length) ? farthest / length : 0.0;
            area.add(flat(corner) + path);
        }
    });
    return area;
}

/// Which vertices move during the clip, and the bounds of those that do.
struct Moving {
    std::vector<bool> moves;
    Bounds bounds;
    bool all = true;  ///< every triangle moves
};

Moving movingOf(const Scene& scene, const MotionMesh& first) {
    Moving moving;
    moving.moves.assign(first.positionsOpen.size(), false);
    if (!(scene.duration() > 0.0)) return moving;
    // Twice, so that one mesh at a time is held.
    atTimes(scene, 4, [&](double seconds) {
        const MotionMesh mesh = scene.motionMesh(seconds, seconds);
        for (std::size_t v = 0; v < moving.moves.size(); ++v)
            if (mesh.positionsOpen[v] != first.positionsOpen[v]) moving.moves[v] = true;
    });
    const auto isMoving = [&](const glm::u32vec3& t) {
        return moving.moves[t.x] || moving.moves[t.y] || moving.moves[t.z];
    };
    const auto& triangles = first.topology->triangles;
    moving.all = std::all_of(triangles.begin(), triangles.end(), isMoving);
    if (std::none_of(triangles.begin(), triangles.end(), isMoving)) return moving;
    atTimes(scene, 4, [&](double seconds) {
        const MotionMesh mesh = scene.motionMesh(seconds, seconds);
        for (const glm::u32vec3& t : triangles)
            for (int c = 0; isMoving(t) && c < 3; ++c) moving.bounds.add(mesh.positionsOpen[t[c]]);
    });
    return moving;
}

/// Counts the cells of an area whose middle lies below some triangle.
class Cells {
  public:
    explicit Cells(const Area& area) : area_(area), covered_(side * side, false) {}

    void cover(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
        const glm::dvec2 low = cellAt(glm::min(a, glm::min(b, c))), high = cellAt(glm::max(a, glm::max(b, c)));
        for (int y = std::max(0, static_cast<int>(low.y)); y <= std::min<double>(side - 1, high.y); ++y)
            for (int x = std::max(0, static_cast<int>(low.x)); x <= std::min<double>(side - 1, high.x); ++x) {
                const glm::dvec2 middle =
                    area_.low + (area_.high - area_.low) * (glm::dvec2(x, y) + 0.5) / static_cast<double>(side);
                const double ab = across(a, b, middle), bc = across(b, c, middle), ca = across(c, a, middle);
                if ((ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0))
                    covered_[static_cast<std::size_t>(y * side + x)] = true;
            }
    }
    double share() const {
        return static_cast<double>(std::count(covered_.begin(), covered_.end(), true)) / (side * side);
    }

  private:
    static constexpr int side = 32;

    static double across(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    }
    /// Held to a little beyond the area, so that it fits a whole number.
    glm::dvec2 cellAt(const glm::dvec2& point) const {
        const glm::dvec2 share = (point - area_.low) / glm::max(area_.high - area_.low, glm::dvec2(1e-300));
        return glm::clamp(glm::floor(share * static_cast<double>(side)), -1.0, static_cast<double>(side));
    }

    Area area_;
    std::vector<bool> covered_;
};

bool facesUp(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, bool twoSided) {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double up = twoSided ? std::abs(normal.y) : normal.y;
    return up > 0.5 * glm::length(normal);
}

}  // namespace

bool lacksGround(const Scene& scene) {
    const MotionMesh mesh = scene.motionMesh(0.0, 0.0);
    const Moving moving = movingOf(scene, mesh);
    const bool some = !moving.bounds.empty() && !moving.all;
    const Bounds& things = some ? moving.bounds : scene.bounds();
    // Below the middle of what moves lies what stands still; of one thing alone, its lowest tenth.
    const double highest = things.low.y + (some ? 0.5 : 0.1) * (things.high.y - things.low.y);
    const MeshTopology& topology = *mesh.topology;
    Cells cells(areaWithShadow(scene, things));
    for (std::size_t i = 0; i < topology.triangles.size(); ++i) {
        const glm::u32vec3 t = topology.triangles[i];
        if (some && (moving.moves[t.x] || moving.moves[t.y] || moving.moves[t.z])) continue;
        const glm::dvec3 &a = mesh.positionsOpen[t.x], &b = mesh.positionsOpen[t.y], &c = mesh.positionsOpen[t.z];
        if (std::max({a.y, b.y, c.y}) > highest) continue;
        if (facesUp(a, b, c, scene.materials()[topology.triangleMaterials[i]].doubleSided))
            cells.cover(flat(a), flat(b), flat(c));
    }
    return cells.share() < 0.5;
}

GroundSquare fittedGround(const Scene& scene) {
    const Bounds& bounds = scene.bounds();
    double lowest = bounds.low.y;
    const MotionMesh first = scene.motionMesh(0.0, 0.0);
    const std::size_t count =
        std::min<std::size_t>(128, mostVertices / std::max<std::size_t>(1, first.positionsOpen.size()));
    const auto look = [&](double seconds) {
        const MotionMesh mesh = scene.motionMesh(seconds, seconds);
        for (const glm::u32vec3& t : mesh.topology->triangles)
            for (int c = 0; c < 3; ++c) lowest = std::min(lowest, mesh.positionsOpen[t[c]].y);
    };
    // Finer than the bounds are sampled, and at keys, between which straight motion has its lowest points.
    if (scene.duration() > 0.0) {
        atTimes(scene, count, look);
        for (const double u : scene.innerMotion(0.0, scene.duration()).instants) look(u * scene.duration());
    }
    const Area area = areaWithShadow(scene, bounds);
    GroundSquare square;
    square.centre = {bounds.centre().x, lowest - groundGap * bounds.diagonal(), bounds.centre().z};
    const glm::dvec2 most = glm::max(area.high - flat(square.centre), flat(square.centre) - area.low);
    const double margin = scene.light(0.0).kind == LightKind::Spot ? spotMargin : sunMargin;
    square.side = 2.0 * margin * std::max({most.x, most.y, 0.25 * bounds.diagonal()});
    return square;
}

Bounds boundsWithShadow(const Scene& scene) {
    Bounds bounds = scene.bounds();
    const Area area = areaWithShadow(scene, bounds, farthestSeen);
    bounds.add(glm::dvec3(area.low.x, bounds.low.y, area.low.y));
    bounds.add(glm::dvec3(area.high.x, bounds.low.y, area.high.y));
    return bounds;
}

}  // namespace timeshade
