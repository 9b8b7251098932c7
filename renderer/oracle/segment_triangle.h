#pragma once

#include <glm/glm.hpp>

namespace timeshade::oracle {

/// How far a float's rounding may move a point, relative to its coordinates: what `marginal` means.
inline constexpr double marginalShare = 1e-6;

/// The part low < s < high of the line from + s (to - from). Both points are taken as exact.
struct Segment {
    glm::dvec3 from, to;
    double low = 0.0, high = 1.0;
    double reach = 0.0;      ///< how far from `from` anything of interest lies; infinity if not known
    double clearance = 0.0;  ///< a triangle whose plane is not farther from `from` than this is not met
};

struct Meeting {
    bool hit = false;
    bool marginal = false;  ///< moving things by marginalShare of their coordinates could decide otherwise
    int facing = 0;         ///< of a hit: 1 if the triangle's front (counter-clockwise) looks towards `from`, else -1
    bool facingMarginal = false;
    double s = 0.0;  ///< where the line meets the plane, to double precision; of a hit or a marginal miss
};

/// Does the segment meet the triangle? Triangles are closed: their edges and corners count. The segment is open: its
/// ends do not. A triangle seen edge-on (in one plane with the segment) or without area is not met. Every decision but
/// that on clearance is exact for the given numbers: signs of determinants in double where their error bound allows,
/// else in exact arithmetic. So a segment through the common edge of two triangles meets at least one of them.
Meeting meet(const Segment& segment, const glm::dvec3 (&vertices)[3]);

}  // namespace timeshade::oracle
