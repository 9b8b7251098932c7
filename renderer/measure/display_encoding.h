#pragma once

#include "image/image_file.h"
#include "plan/display_look.h"

namespace timeshade {

/// What the display pass makes of an image, on the CPU (the same shared curves, within one level).
DisplayImage displayed(const LinearImage& image, const DisplayLook& look = {});

}  // namespace timeshade
