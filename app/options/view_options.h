#pragma once

#include "options/picture_options.h"
#include "options/run_options.h"

namespace timeshade {

/// `timeshade view`: the window.
struct ViewOptions : PictureOptions, RunOptions {};

}  // namespace timeshade
