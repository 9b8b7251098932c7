#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace timeshade {

/// Reads a whole file. Throws Error, "cannot read PATH: REASON", also for a folder, a pipe or a device, and for a file
/// of more than `most` bytes, of which no more are read or allocated.
std::vector<unsigned char> readFileBytes(const std::filesystem::path& path,
                                         std::size_t most = std::numeric_limits<std::size_t>::max());

/// The same as text.
std::string readFileText(const std::filesystem::path& path, std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace timeshade
