#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "core/memory_budget.h"
#include "core/sha256.h"
#include "scene/gltf_files.h"

namespace timeshade::gltf {

/// The parts of a .gltf or .glb file, not yet validated.
struct Document {
    nlohmann::json json;                       ///< an object
    std::shared_ptr<const Bytes> binaryChunk;  ///< the BIN chunk of a .glb, or null
    Sha256 digest{};                           ///< of the file's bytes
    std::shared_ptr<MemoryBudget> memory;      ///< what all that is made of it is counted in
};

/// Reads the file, unpacks a .glb container, parses the JSON, and throws Error for every required extension that is not
/// supported. Afterwards, indices, counts and offsets are whole numbers in [0, 2^31).
/// What its bytes and its JSON expand to is counted in `memory` before it is allocated.
Document readDocument(const std::filesystem::path& path, std::size_t limit, std::shared_ptr<MemoryBudget> memory);

/// The part of readDocument that works on bytes alone.
Document parseDocument(Bytes bytes, std::shared_ptr<MemoryBudget> memory);

/// Throws Error for structure that later steps would misread: indices, counts and offsets that are not integers,
/// sections that are not lists of objects. Whole numbers written as 3.0 become 3.
void checkStructure(nlohmann::json& root);

}  // namespace timeshade::gltf
