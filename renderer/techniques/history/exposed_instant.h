#pragma once

#include "shared/frame_blocks.shared.h"

namespace timeshade {

/// The time u until which a shutter with the block's response has had that share of its exposure, within 1e-6; shares
/// that are spread evenly over [0, 1] give instants with the density of the response. `share` itself for a box.
double exposedInstant(const shared::FrameBlock& block, double share);

}  // namespace timeshade
