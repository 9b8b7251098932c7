#include "measure/user_folder.h"

#include <cstdlib>

namespace timeshade {

namespace {

std::filesystem::path pathIn(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr ? value : "";
}

}  // namespace

std::filesystem::path userFolder(const char* variable, const char* withoutIt) {
    // The specification: paths that are not absolute are to be ignored.
    if (const std::filesystem::path folder = pathIn(variable); folder.is_absolute()) return folder / "timeshade";
    const std::filesystem::path home = pathIn("HOME");
    return home.is_absolute() ? home / withoutIt / "timeshade" : std::filesystem::path();
}

}  // namespace timeshade
