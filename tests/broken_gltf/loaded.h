#pragma once

#include <algorithm>
#include <memory>
#include <string>

#include "core/error.h"
#include "gltf_writer.h"
#include "scene/gltf_scene.h"

namespace timeshade::test {

/// The file as a scene, read from a folder of its own.
inline std::unique_ptr<Scene> loaded(const GltfFile& file, const GltfOptions& options = {}) {
    const TemporaryFolder folder;
    return loadGltf(folder.write("test.glb", file.glb()), options);
}

/// Why the file is refused; empty where it is not.
inline std::string refusal(const GltfFile& file, const GltfOptions& options = {}) {
    try {
        loaded(file, options);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// How many of the scene's notes hold a text.
inline std::size_t notesWith(const Scene& scene, const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(scene.notes().begin(), scene.notes().end(),
                      [&](const std::string& note) { return note.find(text) != std::string::npos; }));
}

}  // namespace timeshade::test
