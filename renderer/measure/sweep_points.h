#pragma once

#include <memory>
#include <string>
#include <vector>

#include "measure/sweep.h"

namespace timeshade {

/// The scene's points, by technique, map and sample count; of the Embree baseline, which has no map, with the first.
std::vector<SweepPoint> pointsOf(const SweepOptions& options, const SweepScene& scene);

bool isBaseline(const SweepPoint& point);

/// The scene's request with what a point varies of it.
FrameRequest requestOf(const SweepScene& scene, const SweepPoint& point);

/// The point's technique, with the sweep's settings and its own.
std::unique_ptr<Technique> makeSubject(const SweepPoint& point, const SweepOptions& options,
                                       gl::ProgramCache& programs);

}  // namespace timeshade
