#include "measure/scene_file_name.h"

#include <cctype>
#include <filesystem>

namespace timeshade {

std::string sceneFileName(const std::string& scene) {
    std::string name = std::filesystem::path(scene).stem().string();
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_') c = '_';
    return name;
}

}  // namespace timeshade
