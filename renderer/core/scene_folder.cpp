#include "core/scene_folder.h"

#include <cstdlib>

#include "core/data_folder.h"

namespace timeshade {

std::filesystem::path sceneFolder() {
    if (const char* folder = std::getenv("TIMESHADE_SCENES")) return folder;
    return dataFolder() / "assets" / "scenes";
}

}  // namespace timeshade
