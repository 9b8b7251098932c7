#pragma once

#include <nlohmann/json.hpp>

#include "scene/gltf_model.h"

namespace timeshade::gltf {

/// Adds the channels of KHR_animation_pointer that drive a node's transform or morph weights, or a light's colour,
/// intensity, range or cone, to the model's animations, and one note that names all others. `root` has passed
/// checkStructure(); indices in pointers are not checked.
void readPointers(const nlohmann::json& root, Model& model);

}  // namespace timeshade::gltf
