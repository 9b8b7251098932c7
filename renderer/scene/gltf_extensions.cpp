#include "scene/gltf_extensions.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "core/one_line.h"
#include "scene/gltf_compression.h"

namespace timeshade::gltf {

namespace {

using Json = nlohmann::json;
using Pointer = Json::json_pointer;

constexpr std::array<std::string_view, 6> readExtensions{"EXT_mesh_gpu_instancing", "KHR_animation_pointer",
                                                         "KHR_lights_punctual",     "KHR_materials_emissive_strength",
                                                         "KHR_mesh_quantization",   "KHR_texture_transform"};

/// Extensions that change neither shapes nor motion nor what casts shadows; and the first parts of the names of whole
/// families of such.
constexpr std::array<std::string_view, 21> lookExtensions{"KHR_texture_basisu",      "KHR_texture_float",
                                                          "KHR_techniques_webgl",    "KHR_xmp",
                                                          "KHR_xmp_json_ld",         "KHR_audio",
                                                          "KHR_audio_emitter",       "EXT_texture_webp",
                                                          "EXT_texture_avif",        "EXT_texture_exr",
                                                          "EXT_texture_astc",        "EXT_lights_image_based",
                                                          "EXT_lights_ies",          "EXT_mesh_features",
                                                          "EXT_instance_features",   "EXT_structural_metadata",
                                                          "EXT_feature_metadata",    "EXT_primitive_voxels",
                                                          "FB_geometry_metadata",    "MSFT_texture_dds",
                                                          "CESIUM_primitive_outline"};
constexpr std::array<std::string_view, 6> lookFamilies{"KHR_materials_",  "EXT_materials_", "ADOBE_materials_",
                                                       "VRMC_materials_", "MSFT_packing_",  "AGI_stk_metadata"};

bool isRead(std::string_view name) {
    return decodes(name) || std::find(readExtensions.begin(), readExtensions.end(), name) != readExtensions.end();
}

bool changesLooksAlone(std::string_view name) {
    return std::find(lookExtensions.begin(), lookExtensions.end(), name) != lookExtensions.end() ||
           std::any_of(lookFamilies.begin(), lookFamilies.end(),
                       [&](std::string_view family) { return name.starts_with(family); });
}

/// The names in one of the two lists of extensions. Throws Error where `strict` and it is not a list of names.
std::vector<std::string> namesIn(const Json& root, const char* list, bool strict) {
    std::vector<std::string> names;
    const auto found = root.find(list);
    if (found == root.end()) return names;
    if (strict && !found->is_array()) throw Error(fmt::format("{} is not a list", list));
    if (!found->is_array()) return names;
    for (const Json& name : *found) {
        if (strict && !name.is_string()) throw Error(fmt::format("{} holds something that is not a name", list));
        if (name.is_string()) names.push_back(name.get<std::string>());
    }
    return names;
}

/// The compression of an element that this build can't undo; empty where there is none.
std::string_view compressionOf(const Json& element) {
    const auto extensions = element.is_object() ? element.find("extensions") : element.end();
    if (extensions == element.end() || !extensions->is_object()) return {};
    for (const std::string_view name :
         {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"})
        if (extensions->contains(name) && !decodes(name)) return name;
    return {};
}

}  // namespace

const Json& elements(const Json& parent, const char* section) {
    static const Json none = Json::array();
    const auto found = parent.is_object() ? parent.find(section) : parent.end();
    return found != parent.end() && found->is_array() ? *found : none;
}

bool hasData(const Json& root, const Json& primitive) {
    const Pointer position("/attributes/POSITION");
    if (!primitive.contains(position) || !primitive[position].is_number_integer()) return true;
    const auto index = primitive[position].get<std::size_t>();
    const Json& accessors = elements(root, "accessors");
    return index >= accessors.size() || accessors[index].contains("bufferView") || accessors[index].contains("sparse");
}

std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t most = 8;
    if (names.size() <= most) return fmt::format("{}", fmt::join(names, ", "));
    return fmt::format("{} and {} more", fmt::join(names.begin(), names.begin() + most, ", "), names.size() - most);
}

void refuseUnsupportedExtensions(const Json& root) {
    for (const std::string& name : namesIn(root, "extensionsRequired", true))
        if (!isRead(name) && !changesLooksAlone(name))
            throw Error(
                fmt::format("needs the glTF extension {}, which is not supported (supported: {}, and those that "
                            "change looks alone)",
                            oneLine(name, 60), fmt::join(readExtensions, ", ")));
}

void refuseCompressedGeometry(const Json& root) {
    std::size_t number = 0;
    for (const Json& mesh : elements(root, "meshes")) {
        for (const Json& primitive : elements(mesh, "primitives"))
            if (const std::string_view name = compressionOf(primitive); !name.empty() && !hasData(root, primitive))
                throw Error(
                    fmt::format("mesh {} is compressed with {}, which is not supported, and is there in no "
                                "other form",
                                number, name));
        ++number;
    }
    number = 0;
    for (const Json& buffer : elements(root, "buffers")) {
        if (const std::string_view name = compressionOf(buffer); !name.empty() && !buffer.contains("uri"))
            throw Error(
                fmt::format("buffer {} is compressed with {}, which is not supported, and is there in no other "
                            "form",
                            number, name));
        ++number;
    }
}

std::vector<std::string> notesOnExtensions(const Json& root) {
    std::set<std::string> used;
    for (const char* list : {"extensionsUsed", "extensionsRequired"})
        for (const std::string& name : namesIn(root, list, false)) used.insert(oneLine(name, 60));
    std::vector<std::string> looks, others, notes;
    for (const std::string& name : used) {
        if (isRead(name)) continue;
        (changesLooksAlone(name) ? looks : others).push_back(name);
    }
    if (!looks.empty())
        notes.push_back(fmt::format("glTF extensions that change looks alone are left out: {}", listed(looks)));
    if (!others.empty()) notes.push_back(fmt::format("glTF extensions are left out: {}", listed(others)));
    return notes;
}

}  // namespace timeshade::gltf
