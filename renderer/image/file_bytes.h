#pragma once

#include <filesystem>
#include <vector>

namespace timeshade {

/// Reads a whole file. Throws Error, "cannot read PATH: REASON", also for a folder, a pipe or a device.
std::vector<unsigned char> readFileBytes(const std::filesystem::path& path);

}  // namespace timeshade
