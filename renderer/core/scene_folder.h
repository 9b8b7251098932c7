#pragma once

#include <filesystem>

namespace timeshade {

/// Where the scenes lie that are files: TIMESHADE_SCENES where that is set; else assets/scenes in the data folder.
std::filesystem::path sceneFolder();

}  // namespace timeshade
