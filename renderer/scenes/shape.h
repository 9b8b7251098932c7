#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

namespace timeshade {

/// Triangles about a point of their own, counter-clockwise seen from outside. Vertices that lie on one another lie
/// there exactly, so that closed shapes stay closed wherever they are moved.
struct Shape {
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;  ///< unit, one per vertex
    std::vector<glm::u32vec3> triangles;

    void add(const Shape& other);
};

/// A rectangle in the plane y = 0 about the origin, facing up, of cells x cells squares: 2 * cells^2 triangles.
Shape plane(double width, double depth, int cells);

/// A box about the origin with flat sides, closed, its sides divided into a grid that has `cells` cells along each
/// axis: 4 (xy + yz + zx) triangles.
Shape box(const glm::dvec3& size, const glm::ivec3& cells);

/// An icosahedron whose sides are divided into frequency^2 triangles each, blown up to the unit sphere: closed, convex,
/// 20 frequency^2 triangles of nearly equal size.
Shape geodesicSphere(int frequency);

/// The shape stretched along its axes. factors > 0.
Shape stretched(Shape shape, const glm::dvec3& factors);

/// A profile of (radius, height), from below to above, turned about the y axis: closed, with flat bands round the axis.
/// The first and the last radius are 0, the others are not; at least three points and three sides.
Shape turned(const std::vector<std::pair<double, double>>& profile, int sides);

}  // namespace timeshade
