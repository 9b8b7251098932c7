#pragma once

#include <string>

#include "options/compare_options.h"
#include "options/frame_options.h"
#include "options/run_options.h"
#include "options/technique_options.h"

namespace timeshade {

/// `timeshade pictures`: every built-in scene that is a file.
struct PicturesOptions : FrameOptions, TechniqueOptions, CompareOptions, RunOptions {
    std::string output;  ///< a folder
};

}  // namespace timeshade
