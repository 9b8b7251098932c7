#pragma once

#include <string>

#include "image/image_file.h"
#include "measure/epipolar_view.h"

namespace timeshade {

/// Two panels side by side, x along the line to the right and u upwards: the truth, and what the technique stored.
/// Both are shaded by distance from the light on one scale, brighter being nearer; where another object of the truth
/// begins there is a dark line. Marks of an interval are areas, those of an instant are points. The receivers of the
/// samples are curves, thick over what a value averages; the samples are discs, from black (shadowed) to white (lit):
/// by the oracle on the left, by the technique on the right, there with a red ring where the two differ.
DisplayImage drawEpipolarView(const EpipolarView& view, const std::string& techniqueTitle);

/// Cells of the stored panel, as of EpipolarView::truth: the distance of the nearest of the marks of intervals there,
/// of whatever opacity; infinity where there is none.
std::vector<double> nearestStored(const EpipolarView& view);

}  // namespace timeshade
