#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "scene/gltf_files.h"

namespace timeshade::gltf {

/// A .gltf or .glb file taken apart, before anything in it is believed.
struct Document {
    nlohmann::json json;                       ///< an object
    std::shared_ptr<const Bytes> binaryChunk;  ///< the BIN chunk of a .glb, null where there is none
};

/// Reads the file, undoes the .glb container, parses the JSON and refuses, by name, every required extension that
/// is not supported. Numbers in the places of indices, counts and offsets are whole and lie in [0, 2^31).
Document readDocument(const std::filesystem::path& path, std::size_t limit);

/// The part of readDocument that works on bytes alone.
Document parseDocument(Bytes bytes);

/// Refuses what would be misread later on: numbers that are no integers where indices, counts and offsets stand,
/// sections that are no lists of objects. Whole numbers written as 3.0 become 3.
void checkStructure(nlohmann::json& root);

}  // namespace timeshade::gltf
