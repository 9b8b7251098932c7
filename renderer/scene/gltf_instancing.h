#pragma once

#include "scene/gltf_model.h"

namespace timeshade::gltf {

/// Replaces the mesh of every node that has instances (EXT_mesh_gpu_instancing) by children that have it, one an
/// instance: its translation, rotation and scale are theirs. What they take is counted against the model's budget, and
/// their triangles against `mostTriangles`, before there are any. A mesh that a skin deforms follows its joints alone:
/// it stays one, with a note. `model` must be validated; it is valid after that, too. Throws Error where an attribute
/// has another shape, or not as many elements as the others.
void expandInstances(Model& model, std::size_t mostTriangles);

}  // namespace timeshade::gltf
