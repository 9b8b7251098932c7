#pragma once

#include <filesystem>

namespace timeshade {

/// The program's own folder below the one that an environment variable of the XDG base directory specification names,
/// as "XDG_CACHE_HOME"; below `withoutIt` in the home folder, as ".cache", where that is not set to an absolute path;
/// empty without a home. It need not be there.
std::filesystem::path userFolder(const char* variable, const char* withoutIt);

}  // namespace timeshade
