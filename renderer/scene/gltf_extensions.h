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

/// Notes on the extensions that the file uses and that are left out, each named once.
std::vector<std::string> notesOnExtensions(const nlohmann::json& root);

/// The elements of a section; none where there is no such list.
const nlohmann::json& elements(const nlohmann::json& parent, const char* section);

/// Whether a primitive is there in another form than compressed: its positions have data of their own.
bool hasData(const nlohmann::json& root, const nlohmann::json& primitive);

/// The first few names, and how many more there are.
std::string listed(const std::vector<std::string>& names);

}  // namespace timeshade::gltf
