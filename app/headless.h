#pragma once

#include "options.h"

namespace timeshade {

/// `timeshade shot`: one picture or a sequence of them. Returns the exit code.
int runShot(const Options& options);
/// `timeshade pictures`: every built-in scene into a folder.
int runPictures(const Options& options);
/// `timeshade list`.
int runList(const Options& options);

} // namespace timeshade
