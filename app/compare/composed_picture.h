#pragma once

#include <string>

#include "compare/compare_mode.h"
#include "image/image_file.h"

namespace timeshade {

/// Two pictures of one size as one of that size. `seam` in [0, 1] is the share of the width that is the first's, for a
/// wipe; `gain` is how many times as bright a difference is drawn.
DisplayImage composed(const DisplayImage& first, const DisplayImage& second, CompareMode mode, double seam, int gain);

/// The same in linear light; a difference is not amplified.
LinearImage composed(const LinearImage& first, const LinearImage& second, CompareMode mode, double seam);

/// "4 x |TSM, 8 spp - Exact, 8 spp|"
std::string differenceLabel(int gain, const std::string& first, const std::string& second);

/// Column at which a wipe's second picture begins.
int seamColumn(int width, double seam);

}  // namespace timeshade
