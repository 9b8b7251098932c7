#pragma once

#include "image/image_file.h"

namespace timeshade {

/// What the display pass makes of an image, on the CPU (the same shared curve, within one level): filmic curve and
/// sRGB encoding where toneMapped, sRGB encoding alone where not.
DisplayImage displayed(const LinearImage& image, bool toneMapped);

}  // namespace timeshade
