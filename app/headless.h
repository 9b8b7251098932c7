#pragma once

#include "options.h"

namespace timeshade {

/// `timeshade shot`: one picture or a sequence of them. Returns the exit code.
int runShot(const Options& options);
/// `timeshade record`: a video or a folder of pictures.
int runRecord(const Options& options);
/// `timeshade pictures`: every built-in scene into a folder.
int runPictures(const Options& options);
/// `timeshade cases`: the matrix of techniques and hard cases. 1 where a verdict is wrong.
int runCases(const Options& options);
/// `timeshade list`.
int runList(const Options& options);

}  // namespace timeshade
