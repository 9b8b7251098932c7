#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "core/memory_budget.h"
#include "scene/loading.h"
#include "scene/scene.h"

namespace timeshade {

struct GltfOptions {
    std::string clip{};   ///< name of the animation to play; empty for the first
    std::string light{};  ///< name or number (from 1) of the light to use; "fitted" for none; empty for the usual one
    /// Files that need more triangles or vertices, or more bytes of buffers, are refused with an Error.
    std::size_t maxTriangles = 20'000'000;
    std::size_t maxBufferBytes = std::size_t{2} << 30;
    /// So are files whose scene needs more bytes than this: JSON, buffers, images, keys, joints, and triangles,
    /// vertices and morph targets over all instances, each by what it expands to and before it is allocated.
    std::uint64_t memoryLimit = quarterOfMemory();
    LoadingWatch watch{};  ///< may be empty
};

/// Reads a .gltf or .glb file. The result is a valid scene (indices in range, finite positions, unit normals, weights
/// that sum to one) or an Error of one line, whatever the file contains; LoadingCancelled of the watch is passed on. A
/// file without a light or camera gets a fitted one. What is supported and what is refused: docs/architecture.md,
/// "Reading glTF".
std::unique_ptr<Scene> loadGltf(const std::filesystem::path& path, const GltfOptions& options = {});

}  // namespace timeshade
