#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

namespace timeshade {

/// Triangles in object space, counter-clockwise seen from outside. Vertices that coincide are bitwise equal, so that
/// closed shapes stay closed under any transform.
struct Shape {
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;             ///< unit, one per vertex
    std::vector<glm::vec2> textureCoordinates;  ///< one per vertex; or none, for a shape without
    std::vector<glm::vec3> colours;  ///< linear, one per vertex, times which the material's counts; or none, for white
    std::vector<glm::u32vec3> triangles;

    void add(const Shape& other);
};

/// A rectangle in the plane y = 0, centred on the origin, facing up, divided into cells x cells: 2 * cells^2 triangles.
/// cells >= 1. Texture coordinates run from 0 to 1 with x and with z.
Shape plane(double width, double depth, int cells);

/// A closed box centred on the origin, with flat normals, its sides divided into `cells` cells along each axis (>= 1):
/// 4 (xy + yz + zx) triangles.
Shape box(const glm::dvec3& size, const glm::ivec3& cells);

/// An icosahedron whose sides are divided into frequency^2 triangles each and projected onto the unit sphere: closed,
/// convex, 20 frequency^2 triangles of nearly equal size. frequency >= 1.
Shape geodesicSphere(int frequency);

/// The shape scaled along its axes. factors > 0.
Shape stretched(Shape shape, const glm::dvec3& factors);

/// A surface of revolution about the y axis: the profile is a list of (radius, height) from bottom to top. Closed;
/// bands have flat normals along the profile. The first and the last radius must be 0 and the others positive; at least
/// three points and three sides (checked).
Shape turned(const std::vector<std::pair<double, double>>& profile, int sides);

}  // namespace timeshade
