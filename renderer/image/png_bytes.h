#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "image/image_file.h"

namespace timeshade {

/// The bytes of the file that writePng writes; `path` names it in an Error.
std::vector<char> pngBytes(const std::filesystem::path& path, const DisplayImage& image, const std::string& note = {});

}  // namespace timeshade
