#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "scene/scene.h"

namespace timeshade {

struct GltfOptions {
    std::string clip{};  ///< name of the animation to play; empty for the first
    /// Files that would need more than this many triangles, vertices or bytes of buffers are refused by name.
    std::size_t maxTriangles = 20'000'000;
    std::size_t maxBufferBytes = std::size_t{2} << 30;
};

/// Reads a .gltf or .glb file. Whatever is in the file, the outcome is a scene that every later stage can rely
/// on (indices in range, finite positions, unit normals, weights that sum to one) or an Error of one line.
/// The rules are those of design section 6.
std::unique_ptr<Scene> loadGltf(const std::filesystem::path& path, const GltfOptions& options = {});

}  // namespace timeshade
