#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "core/sha256.h"
#include "scene/gltf_files.h"

namespace timeshade::gltf {

/// The parts of a .gltf or .glb file, not yet validated.
struct Document {
    nlohmann::json json;                       ///< an object
    std::shared_ptr<const Bytes> binaryChunk;  ///< the BIN chunk of a .glb, or null
    Sha256 digest{};                           ///< of the file's bytes
};

/// Reads the file, unpacks a .glb container, parses the JSON, and throws Error for every required extension that is not
/// supported. Afterwards, indices, counts and offsets are whole numbers in [0, 2^31).
Document readDocument(const std::filesystem::path& path, std::size_t limit);

/// The part of readDocument that works on bytes alone.
Document parseDocument(Bytes bytes);

/// Throws Error for structure that later steps would misread: indices, counts and offsets that are not integers,
/// sections that are not lists of objects. Whole numbers written as 3.0 become 3.
void checkStructure(nlohmann::json& root);

}  // namespace timeshade::gltf
