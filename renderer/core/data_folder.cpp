#include "core/data_folder.h"

#include <cstdlib>
#include <system_error>

#include <timeshade/paths.h>

namespace timeshade {

namespace {

std::filesystem::path builtInFolder() {
    std::error_code ignored;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    const std::filesystem::path installed = program.parent_path().parent_path() / "share" / "timeshade";
    if (!program.empty() && std::filesystem::is_directory(installed / "shaders", ignored)) return installed;
    return TIMESHADE_SOURCE_DIRECTORY;
}

}  // namespace

std::filesystem::path dataFolder() {
    if (const char* folder = std::getenv("TIMESHADE_DATA")) return folder;
    static const std::filesystem::path builtIn = builtInFolder();  // asked for with every file of every shader
    return builtIn;
}

}  // namespace timeshade
