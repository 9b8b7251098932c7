#pragma once

#include "compare/compare_mode.h"
#include "image/image_file.h"

namespace timeshade {

/// Two pictures of one size as one of that size. `seam` in [0, 1] is the share of the width that is the first's, for a
/// wipe.
DisplayImage composed(const DisplayImage& first, const DisplayImage& second, CompareMode mode, double seam);

/// The same in linear light; a difference is not amplified.
LinearImage composed(const LinearImage& first, const LinearImage& second, CompareMode mode, double seam);

/// Column at which a wipe's second picture begins.
int seamColumn(int width, double seam);

}  // namespace timeshade
