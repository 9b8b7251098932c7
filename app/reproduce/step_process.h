#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace timeshade {

/// Runs this very program with the arguments, in `folder`, without a shell; what it says goes into said.txt and
/// complained.txt there. Returns its exit code, 128 and the signal where one has ended it. A stop signal (StopSignals)
/// is handed on to it. Throws Error where it cannot be started.
int runThisProgram(const std::vector<std::string>& arguments, const std::filesystem::path& folder);

}  // namespace timeshade
