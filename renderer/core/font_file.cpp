#include "core/font_file.h"

#include <system_error>

#include "core/data_folder.h"

namespace timeshade {

std::filesystem::path fontFile(std::string_view name) {
    std::error_code ignored;
    const std::filesystem::path own = dataFolder() / "fonts" / name;
    if (std::filesystem::is_regular_file(own, ignored)) return own;
    return std::filesystem::path("/usr/share/fonts/truetype/dejavu") / name;
}

}  // namespace timeshade
