#pragma once

#include <string>
#include <vector>

#include "scene/gltf_model.h"
#include "scene/material.h"

namespace timeshade::gltf {

struct Looks {
    std::vector<Material> materials;  ///< never empty: the last is glTF's default material
    std::vector<Image> images;        ///< those that some material shows
};

/// Materials with their images decoded. An image that cannot be had costs the texture, and a note, no more.
Looks readLooks(const Model& model, FilesBeside& files, std::vector<std::string>& notes);

}  // namespace timeshade::gltf
