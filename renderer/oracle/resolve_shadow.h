#pragma once

#include "oracle/cutout_cover.h"
#include "oracle/segment_triangle.h"
#include "oracle/swept_bvh.h"

namespace timeshade::oracle {

struct ResolvedShadow {
    bool lit = true;
    bool marginal = false;
};

/// The definition itself, in exact arithmetic where it takes that: is the segment from `position` to `light` free, at
/// time u, of all triangles but `receiver` (NO_TRIANGLE: of all) and those whose plane is not farther from `position`
/// than `clearance`? Closed triangles; one that is seen edge-on casts no shadow. Marginal: no triangle is met but for a
/// hit or miss that a float's rounding may decide. `cutouts`: where triangles cover; null: all over.
ResolvedShadow resolveShadow(const SweptBvh& bvh, const MovingTriangles& triangles, const glm::dvec3& position,
                             const glm::dvec3& light, double clearance, std::uint32_t receiver, double u,
                             const CutoutCover* cutouts = nullptr);

}  // namespace timeshade::oracle
