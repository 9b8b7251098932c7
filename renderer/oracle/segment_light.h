#pragma once

#include "oracle/seen_segments.h"

namespace timeshade::oracle {

/// For how long the receiver of one segment of a position's ray is lit: what SegmentOracle::litOver promises.
LitSegment litSegment(const FramePlan& plan, const PositionRay& ray, const SeenSegment& segment,
                      const MovingTriangles& triangles, const SweptBvh& bvh);

}  // namespace timeshade::oracle
