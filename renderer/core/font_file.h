#pragma once

#include <filesystem>
#include <string_view>

namespace timeshade {

/// A font of DejaVu, as "DejaVuSans.ttf": that of the data folder's fonts/, if it has one, else of the package
/// fonts-dejavu-core, whether that is installed or not.
std::filesystem::path fontFile(std::string_view name);

}  // namespace timeshade
