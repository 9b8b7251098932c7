#include "window/recent_files.h"

#include <algorithm>
#include <filesystem>

namespace timeshade {

void RecentFiles::add(const std::string& sceneName) {
    if (!sceneName.ends_with(".gltf") && !sceneName.ends_with(".glb")) return;
    const std::string path = std::filesystem::absolute(sceneName).lexically_normal().string();
    std::erase(paths_, path);
    paths_.insert(paths_.begin(), path);
    paths_.resize(std::min<std::size_t>(paths_.size(), 8));
}

}  // namespace timeshade
