#pragma once

#include <string>
#include <vector>

#include "scene/gltf_model.h"
#include "scene/loading.h"
#include "scene/material.h"

namespace timeshade::gltf {

struct Looks {
    std::vector<Material> materials;  ///< never empty: the last is glTF's default material
    std::vector<Image> images;        ///< those that a material uses
};

/// Materials with decoded images. If an image cannot be read, its texture is left out with a note.
Looks readLooks(const Model& model, FilesBeside& files, std::vector<std::string>& notes, const LoadingWatch& watch);

}  // namespace timeshade::gltf
