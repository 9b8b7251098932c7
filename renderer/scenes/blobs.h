#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scenes/shape.h"

namespace timeshade {

/// A cone with round ends that melts into its neighbours, a part of a body.
struct Blob {
    glm::dvec3 a{0.0}, b{0.0};            ///< both ends; they must differ
    double radiusA = 0.1, radiusB = 0.1;  ///< across z; positive
    double depth = 1.0;                   ///< its extent along z as a share of that along x, in (0, 1]
    double melting = 0.02;                ///< how far apart two surfaces begin to melt into one; > 0, at most 0.1
    std::uint32_t bone = 0;
    std::uint32_t layer = 0;  ///< blobs of different layers do not melt: skin, clothes
    glm::dvec3 cutTo{0.0};    ///< unit; nothing of the blob is farther in this direction than `cutAt`. Zero: no cut
    double cutAt = 0.0;       ///< along that direction from the origin
};

/// About how far outside of the blob a place is; negative inside. Changes by at most 1.3 times the distance.
double distanceTo(const Blob& blob, const glm::dvec3& place);

/// A surface, and of which layer each vertex is.
struct LayeredShape {
    Shape shape;
    std::vector<std::uint32_t> layers;
};

/// The closed surface around all blobs, of triangles about as large as the cell, by surface nets (Gibson 1998) whose
/// vertices are moved on to the surface. Equal arguments make equal surfaces.
LayeredShape surfaceOf(const std::vector<Blob>& blobs, double cell);

}  // namespace timeshade
