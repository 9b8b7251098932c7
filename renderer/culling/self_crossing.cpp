#include "culling/self_crossing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "scene/scene.h"

namespace timeshade {

namespace {

/// The side of the plane through a, b and c that p is on: -1, 1, or 0 within rounding.
int sideOf(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 normal = glm::cross(b - a, c - a), way = p - a;
    const double along = glm::dot(way, normal);
    const double places = glm::length(p) + glm::length(a) + glm::length(b) + glm::length(c);
    const double noise =
        1e-14 * places * (glm::length(normal) + glm::length(way) * (glm::length(b - a) + glm::length(c - a)));
    return std::abs(along) <= noise ? 0 : along > 0.0 ? 1 : -1;
}

/// Whether the segment from p to q intersects the triangle, edges and corners included. False if it lies in its plane.
bool meets(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const int side = sideOf(p, a, b, c), other = sideOf(q, a, b, c);
    if (side == other) return false;
    const int ab = sideOf(q, p, a, b), bc = sideOf(q, p, b, c), ca = sideOf(q, p, c, a);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

bool has(const glm::u32vec3& triangle, std::uint32_t corner) {
    return triangle.x == corner || triangle.y == corner || triangle.z == corner;
}

/// Whether an edge of `a` that shares no corner with `b` intersects `b`.
bool edgesMeet(const std::vector<glm::dvec3>& positions, const glm::u32vec3& a, const glm::u32vec3& b) {
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t from = a[i], to = a[(i + 1) % 3];
        if (has(b, from) || has(b, to)) continue;
        if (meets(positions[from], positions[to], positions[b.x], positions[b.y], positions[b.z])) return true;
    }
    return false;
}

int cornersInCommon(const glm::u32vec3& a, const glm::u32vec3& b) {
    return static_cast<int>(has(b, a.x)) + static_cast<int>(has(b, a.y)) + static_cast<int>(has(b, a.z));
}

bool apart(const Bounds& a, const Bounds& b) {
    return glm::any(glm::greaterThan(a.low, b.high)) || glm::any(glm::greaterThan(b.low, a.high));
}

/// Searches for two triangles that intersect, splitting space in two until few triangles are left in each part.
/// Triangles across a split are in both parts.
class Search {
  public:
    Search(const std::vector<glm::dvec3>& positions, const std::vector<glm::u32vec3>& triangles)
        : positions_(positions), triangles_(triangles) {
        for (const glm::u32vec3& t : triangles) {
            Bounds& box = boxes_.emplace_back();
            for (int corner = 0; corner < 3; ++corner) box.add(positions[t[corner]]);
        }
    }

    bool among(const std::vector<std::uint32_t>& ids) {
        constexpr std::size_t few = 32;
        if (ids.size() <= few) return pairs(ids);
        Bounds all;
        for (const std::uint32_t id : ids) all.add(boxes_[id]);
        const glm::dvec3 extent = all.high - all.low;
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
        std::vector<double> centres;
        for (const std::uint32_t id : ids) centres.push_back(0.5 * (boxes_[id].low[axis] + boxes_[id].high[axis]));
        std::nth_element(centres.begin(), centres.begin() + static_cast<std::ptrdiff_t>(ids.size() / 2), centres.end());
        const double border = centres[ids.size() / 2];
        std::vector<std::uint32_t> below, above;
        for (const std::uint32_t id : ids) {
            if (boxes_[id].low[axis] <= border) below.push_back(id);
            if (boxes_[id].high[axis] >= border) above.push_back(id);
        }
        // If most triangles are across the split, splitting gains nothing.
        if (4 * std::max(below.size(), above.size()) > 3 * ids.size() + few) return pairs(ids);
        return among(below) || among(above);
    }

  private:
    bool pairs(const std::vector<std::uint32_t>& ids) {
        const std::uint64_t count = std::uint64_t{ids.size()} * ids.size() / 2;
        if (count > pairsLeft_) return true;
        pairsLeft_ -= count;
        for (std::size_t i = 0; i < ids.size(); ++i) {
            for (std::size_t k = i + 1; k < ids.size(); ++k) {
                if (apart(boxes_[ids[i]], boxes_[ids[k]])) continue;
                const glm::u32vec3 &a = triangles_[ids[i]], &b = triangles_[ids[k]];
                if (cornersInCommon(a, b) < 2 && (edgesMeet(positions_, a, b) || edgesMeet(positions_, b, a)))
                    return true;
            }
        }
        return false;
    }

    const std::vector<glm::dvec3>& positions_;
    const std::vector<glm::u32vec3>& triangles_;
    std::vector<Bounds> boxes_;
    std::uint64_t pairsLeft_ = 100'000'000;
};

}  // namespace

bool mayCrossItself(const std::vector<glm::dvec3>& positions, const std::vector<glm::u32vec3>& triangles) {
    std::vector<std::uint32_t> all(triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    return Search(positions, triangles).among(all);
}

}  // namespace timeshade
