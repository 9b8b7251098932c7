#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace timeshade::gltf {

/// Throws Error that names the first extension of `extensionsRequired` that is neither read nor changes looks alone.
void refuseUnsupportedExtensions(const nlohmann::json& root);

/// Throws Error that names the compression of geometry that the file holds in no other form, even where it says that
/// the extension is not required. `root` has passed checkStructure().
void refuseCompressedGeometry(const nlohmann::json& root);

/// Notes on the extensions that the file uses and that are left out, each named once, and on animated properties that
/// are left out with them.
std::vector<std::string> notesOnExtensions(const nlohmann::json& root);

}  // namespace timeshade::gltf
