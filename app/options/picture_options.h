#pragma once

#include <string>

#include "options/compare_options.h"
#include "options/frame_options.h"
#include "options/technique_options.h"

namespace timeshade {

/// All that decides a picture.
struct PictureOptions : FrameOptions, TechniqueOptions, CompareOptions {
    std::string scene = "chess";  ///< a built-in name or a path
};

}  // namespace timeshade
