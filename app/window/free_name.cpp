#include "window/free_name.h"

#include <system_error>

#include <fmt/format.h>

namespace timeshade {

std::filesystem::path freeName(const std::filesystem::path& path) {
    std::filesystem::path free = path;
    std::error_code ignored;
    // A link that leads nowhere has its name, too.
    for (int number = 2; std::filesystem::symlink_status(free, ignored).type() != std::filesystem::file_type::not_found;
         ++number)
        free = path.parent_path() / fmt::format("{}-{}{}", path.stem().string(), number, path.extension().string());
    return free;
}

}  // namespace timeshade
