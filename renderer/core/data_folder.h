#pragma once

#include <filesystem>

namespace timeshade {

/// What the program reads as it runs lies here, by the same paths as in the sources: shaders/, assets/,
/// renderer/techniques/NAME/page.png. TIMESHADE_DATA where that is set; else, of a program that is installed,
/// ../share/timeshade from its own folder, wherever that has been moved to; else the folder of the sources that it was
/// built from.
std::filesystem::path dataFolder();

}  // namespace timeshade
