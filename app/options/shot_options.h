#pragma once

#include <optional>
#include <string>

#include "options/picture_options.h"
#include "options/run_options.h"

namespace timeshade {

/// `timeshade shot`: one picture, or one file for each of some frames.
struct ShotOptions : PictureOptions, RunOptions {
    std::string output;         ///< F.png or F.exr
    std::optional<int> frames;  ///< one where not given
};

}  // namespace timeshade
