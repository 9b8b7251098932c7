#pragma once

#include <vector>

#include "oracle/camera_rays.h"
#include "oracle/seen_triangle.h"
#include "oracle/segment_oracle.h"

namespace timeshade::oracle {

/// The ray through a place of the image, moved by so many pixels.
PositionRay positionRay(const FramePlan& plan, glm::vec2 place, glm::dvec2 aside);

/// What it is at time u.
CameraRay rayAt(const PositionRay& ray, double u);

/// The segments of a position's ray: what SegmentOracle::seenBy promises.
std::vector<SeenSegment> seenSegments(const PositionRay& ray, const MovingTriangles& triangles, const SweptBvh& bvh);

}  // namespace timeshade::oracle
