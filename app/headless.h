#pragma once

#include "options/command.h"

namespace timeshade {

/// `timeshade shot`: one picture or a sequence of them. Returns the exit code.
int runShot(const ShotOptions& options);
/// `timeshade record`: a video or a folder of pictures.
int runRecord(const RecordOptions& options);
/// `timeshade pictures`: every built-in scene into a folder.
int runPictures(const PicturesOptions& options);
/// `timeshade cases`: the matrix of techniques and analytic cases. 1 where a verdict is wrong.
int runCases(const CasesOptions& options);
/// `timeshade list`.
int runList(const ListOptions& options);

}  // namespace timeshade
