#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

namespace timeshade::oracle {

/// Triangles whose vertices move linearly: eighteen floats a triangle, three vertices at u = 0 and three at u = 1, in
/// the layout of MeshTexels::positions.
class MovingTriangles {
  public:
    explicit MovingTriangles(std::span<const glm::vec4> texels) : texels_(texels) {}
    std::uint32_t count() const;
    bool doubleSided(std::uint32_t id) const;
    /// Vertices at time u. Triangles that share a vertex get the very same numbers for it.
    void at(std::uint32_t id, double u, glm::dvec3 (&vertices)[3]) const;
    glm::dvec3 end(std::uint32_t id, int vertex, bool close) const;

  private:
    std::span<const glm::vec4> texels_;
};

/// Bounding boxes at both ends of the shutter. What moves linearly stays in the interpolated box.
struct SweptBox {
    glm::dvec3 low[2]{glm::dvec3(1e300), glm::dvec3(1e300)};
    glm::dvec3 high[2]{glm::dvec3(-1e300), glm::dvec3(-1e300)};
    void add(const SweptBox& other);
    double area() const;  ///< surface, both ends together
};

/// A double-precision hierarchy of swept boxes: finds all triangles within `pad` of a line at a time u, and more, never
/// fewer. Its own, so that what is resolved exactly rests on no other tracer.
class SweptBvh {
  public:
    explicit SweptBvh(const MovingTriangles& triangles);

    /// Calls visit(id, limit) for the triangles near from + s * direction, 0 <= s <= limit, nearer boxes first. visit
    /// may lower `limit` and ends the search by returning false.
    template <class Visit>
    void forEachNear(const glm::dvec3& from, const glm::dvec3& direction, double u, double pad, double limit,
                     Visit&& visit) const;

    /// Calls visit(id) for all triangles but those of boxes of which misses(box) is true, in no order.
    template <class Misses, class Visit>
    void forEachUnless(const Misses& misses, Visit&& visit) const;

    double largestCoordinate() const { return largestCoordinate_; }  ///< magnitude, over all vertices at both ends

  private:
    struct Node {
        SweptBox box;
        std::uint32_t first = 0;  ///< leaf: place in order_; else the first of two children that lie side by side
        std::uint32_t count = 0;  ///< triangles of a leaf, 0 for an inner node
    };
    struct Builder;
    static constexpr int maximumDepth = 60;

    /// Where the line enters the padded box at time u, or infinity.
    static double entry(const SweptBox& box, const glm::dvec3& from, const glm::dvec3& inverse, double u, double pad,
                        double limit);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
    double largestCoordinate_ = 0.0;
};

inline double SweptBvh::entry(const SweptBox& box, const glm::dvec3& from, const glm::dvec3& inverse, double u,
                              double pad, double limit) {
    double enter = 0.0, leave = limit;
    for (int c = 0; c < 3; ++c) {
        const double low = box.low[0][c] + (box.low[1][c] - box.low[0][c]) * u - pad;
        const double high = box.high[0][c] + (box.high[1][c] - box.high[0][c]) * u + pad;
        const double a = (low - from[c]) * inverse[c], b = (high - from[c]) * inverse[c];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave ? enter : HUGE_VAL;
}

template <class Visit>
void SweptBvh::forEachNear(const glm::dvec3& from, const glm::dvec3& direction, double u, double pad, double limit,
                           Visit&& visit) const {
    if (nodes_.empty()) return;
    glm::dvec3 inverse;
    // A component of zero becomes so small a one that the line cannot leave a padded box by it.
    for (int c = 0; c < 3; ++c) inverse[c] = 1.0 / (std::abs(direction[c]) > 1e-200 ? direction[c] : 1e-200);
    std::pair<double, std::uint32_t> stack[maximumDepth + 4];
    int size = 0;
    const double root = entry(nodes_[0].box, from, inverse, u, pad, limit);
    if (root <= limit) stack[size++] = {root, 0};
    while (size > 0) {
        const auto [enter, index] = stack[--size];
        if (enter > limit) continue;
        const Node& node = nodes_[index];
        for (std::uint32_t i = 0; i < node.count; ++i)
            if (!visit(order_[node.first + i], limit)) return;
        if (node.count > 0) continue;
        double near = entry(nodes_[node.first].box, from, inverse, u, pad, limit);
        double far = entry(nodes_[node.first + 1].box, from, inverse, u, pad, limit);
        std::uint32_t nearChild = node.first, farChild = node.first + 1;
        if (far < near) {
            std::swap(near, far);
            std::swap(nearChild, farChild);
        }
        if (far < HUGE_VAL) stack[size++] = {far, farChild};
        if (near < HUGE_VAL) stack[size++] = {near, nearChild};
    }
}

template <class Misses, class Visit>
void SweptBvh::forEachUnless(const Misses& misses, Visit&& visit) const {
    if (nodes_.empty() || misses(nodes_[0].box)) return;
    std::uint32_t stack[maximumDepth + 4];
    int size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const Node& node = nodes_[stack[--size]];
        for (std::uint32_t i = 0; i < node.count; ++i) visit(order_[node.first + i]);
        if (node.count > 0) continue;
        for (const std::uint32_t child : {node.first, node.first + 1})
            if (!misses(nodes_[child].box)) stack[size++] = child;
    }
}

}  // namespace timeshade::oracle
