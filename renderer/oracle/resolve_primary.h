#pragma once

#include "oracle/camera_rays.h"
#include "oracle/cutout_cover.h"

namespace timeshade::oracle {

/// The first triangle along the camera ray beyond the near distance, one-sided ones only from their front. Of two at
/// exactly one depth, the one with the lower number. `cutouts`: where triangles cover; null: all over.
Oracle::ResolvedPrimary resolveFirstSeen(const SweptBvh& bvh, const MovingTriangles& triangles, const CameraRay& ray,
                                         double nearDistance, const CutoutCover* cutouts = nullptr);

}  // namespace timeshade::oracle
