#pragma once

#include "options/picture_options.h"
#include "options/run_options.h"

namespace timeshade {

/// `timeshade view`: the window.
struct ViewOptions : PictureOptions, RunOptions {
    bool story = false;  ///< nothing was asked for: what assets/story.json says, with a word on it
};

}  // namespace timeshade
