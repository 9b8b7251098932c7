#pragma once

#include <filesystem>

namespace timeshade {

/// The path, or where there is such a file already, the first that is free of "NAME-2.png", "NAME-3.png" ...
std::filesystem::path freeName(const std::filesystem::path& path);

}  // namespace timeshade
