#pragma once

#include <vector>

#include "scene/scene.h"
#include "technique/technique.h"

namespace timeshade {

/// Per pixel, row by row from the bottom, for how much of the shutter its centre sees light or the background, as the
/// technique says: the mean of the camera samples' instants over `seeds` seeds, or of interval samples their parts,
/// which no seed changes. The request must ask for pixel centres, and with intervals for one position.
std::vector<double> litAtCentres(const Scene& scene, FrameRequest request, Technique& technique, std::uint32_t seeds);

}  // namespace timeshade
