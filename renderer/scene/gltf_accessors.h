#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/gltf_model.h"

namespace timeshade::gltf {

/// Which component types are allowed besides float.
enum class Integers {
    Forbidden,
    Normalized,  ///< 8 and 16 bits, as fractions of the largest value
    Quantized,   ///< 8 and 16 bits, normalised or not (KHR_mesh_quantization)
};

/// All elements of an accessor, `components` numbers each, with sparse values applied. Throws Error if the accessor has
/// another shape or type, or holds a number that is not finite. `what` names the use in messages. `model` must be
/// validated.
std::vector<float> readFloats(const Model& model, int accessor, int components, Integers integers,
                              const std::string& what);

/// Unsigned integers (vertex indices, joints) of 8, 16 or, if `wide`, 32 bits. Throws Error as readFloats().
std::vector<std::uint32_t> readUnsigned(const Model& model, int accessor, int components, bool wide,
                                        const std::string& what);

/// The bytes of a view.
std::span<const std::uint8_t> bytesOf(const Model& model, int view);

}  // namespace timeshade::gltf
