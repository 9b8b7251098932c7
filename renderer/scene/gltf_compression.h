#pragma once

#include <string_view>

#include <nlohmann/json.hpp>

#include "scene/gltf_model.h"

namespace timeshade::gltf {

/// Whether this build has the library that decodes the extension's data: KHR_draco_mesh_compression,
/// EXT_meshopt_compression.
bool decodes(std::string_view extension);

/// Whether a buffer only stands for what compressed views expand to, so that it has no bytes of its own to be read.
bool isFallback(const nlohmann::json& buffer);

/// Replaces what is compressed by views of new buffers that hold what it expands to, which is counted against the
/// model's budget first: buffer views (EXT_meshopt_compression), and the attributes and indices of primitives that are
/// there in no other form (KHR_draco_mesh_compression). The buffers must be loaded; the model need not be valid yet.
/// Throws Error of one line for damaged data.
void decompress(Model& model, const nlohmann::json& root);

/// The steps of decompress(). Each does nothing where decodes() says no.
void decompressViews(Model& model, const nlohmann::json& root);
void decompressPrimitives(Model& model, const nlohmann::json& root);

/// A property of an extension that is a whole number, from `least` to `most`.
std::uint64_t wholeNumber(const nlohmann::json& object, const char* key, std::uint64_t least, std::uint64_t most,
                          const std::string& what);

/// Adds bytes to the model as a buffer with one view. They have been counted.
int addView(Model& model, Bytes bytes, std::uint64_t stride);

}  // namespace timeshade::gltf
