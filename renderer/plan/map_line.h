#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "plan/frame_plan.h"

namespace timeshade {

/// A line in the light's map, in map coordinates: [0, 1] each, the second one upwards. x in [0, 1] runs along it.
struct MapLine {
    glm::dvec2 from{0.0, 0.5}, to{1.0, 0.5};

    glm::dvec2 at(double x) const { return from + x * (to - from); }
    /// x of the foot of a place's perpendicular; outside [0, 1] where that lies beyond an end.
    double alongOf(const glm::dvec2& place) const;
    /// How far a place is from the (endless) line, in texels of a map of this size.
    double texelsFrom(const glm::dvec2& place, const glm::dvec2& size) const;
    /// Length in texels of a map of this size.
    double texels(const glm::dvec2& size) const { return glm::length((to - from) * size); }
};

/// A texel and the part of a line that lies in it.
struct TexelOnLine {
    glm::ivec2 texel{0};
    double xFrom = 0.0, xTo = 0.0;
};

/// The texels of a map that a line crosses, from its beginning to its end. Every x of the line that is inside the map
/// is in one of them; touching a corner counts for none.
std::vector<TexelOnLine> texelsAlong(const MapLine& line, const glm::ivec2& size);

/// Where the light sees a point at time u, in double precision, by the matrices of the light's map.
struct MapPlace {
    glm::dvec2 position{0.0};  ///< map coordinates; inside the map in [0, 1]
    double depth = 0.0;        ///< distance from the light's plane along its axis, world units
};
MapPlace mapPlaceOf(const FramePlan& plan, const glm::dvec3& position, double u);

/// The line of sight of the light through a place of its map at time u: the points from + depth * direction.
struct LightRay {
    glm::dvec3 from{0.0};  ///< on the light's plane, relative to the plan's origin
    glm::dvec3 direction{0.0};
};
LightRay lightRayThrough(const FramePlan& plan, const glm::dvec2& place, double u);

}  // namespace timeshade
