#pragma once

// tinygltf only parses the structure. This importer reads files and images itself.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include "scene/gltf_model.h"

namespace timeshade::gltf {

/// Reads materials, textures and samplers into the model, with notes on what is read in another way than they say.
/// Throws Error where a texture transform is not one, or a texture names a sampler that is not there.
void readMaterials(const tinygltf::Model& from, Model& to);

}  // namespace timeshade::gltf
