#pragma once

#include <filesystem>
#include <vector>

namespace timeshade {

/// The whole file. Throws Error: "cannot read PATH: REASON".
std::vector<unsigned char> readFileBytes(const std::filesystem::path& path);

}  // namespace timeshade
