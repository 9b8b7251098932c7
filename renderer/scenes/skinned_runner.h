#pragma once

#include "scenes/mesh_scene.h"
#include "scenes/run_cycle.h"

namespace timeshade {

/// A runner on the track whose triangles are about as large as the cell, in metres, and who makes two steps in `pace`
/// seconds.
MeshInstance skinnedRunner(double cell, double pace, const Track& track, std::uint32_t material);

}  // namespace timeshade
