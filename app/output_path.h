#pragma once

#include <filesystem>
#include <string>

namespace timeshade {

/// The folder, made with those that it lies in where it is not there yet. Throws Error where it can't be, and for
/// another user's link in its place.
std::filesystem::path madeFolder(const std::filesystem::path& folder);

/// The path as the user can open it from anywhere.
std::string fullPath(const std::filesystem::path& path);

}  // namespace timeshade
