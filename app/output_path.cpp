#include "output_path.h"

#include <fmt/format.h>

#include "core/error.h"
#include "image/part_file.h"

namespace timeshade {

std::filesystem::path madeFolder(const std::filesystem::path& folder) {
    followOwnLinks(folder.has_filename() ? folder : folder.parent_path());
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure)
        throw Error(
            fmt::format("{}: cannot be made ({}); expected a folder to write to", folder.string(), failure.message()));
    return folder;
}

std::string fullPath(const std::filesystem::path& path) {
    return std::filesystem::absolute(path).lexically_normal().string();
}

}  // namespace timeshade
