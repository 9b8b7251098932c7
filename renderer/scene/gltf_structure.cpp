// Stricter than tinygltf, which skips values of the wrong type, so that a mesh index written as a string silently
// becomes "no mesh".

#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/error.h"
#include "core/one_line.h"
#include "scene/gltf_document.h"

namespace timeshade::gltf {

namespace {

using Json = nlohmann::json;

const std::set<std::string_view> integerKeys{
    "buffer",        "bufferView", "byteLength", "byteOffset", "byteStride", "camera",
    "componentType", "count",      "index",      "indices",    "input",      "inverseBindMatrices",
    "material",      "mesh",       "mode",       "node",       "output",     "sampler",
    "scene",         "skeleton",   "skin",       "source",     "texCoord"};
const std::set<std::string_view> integerListKeys{"children", "joints"};

std::string shown(const Json& value) { return oneLine(value.dump(-1, ' ', true, Json::error_handler_t::replace), 40); }

void requireInteger(Json& value, const std::string& where) {
    constexpr double limit = 2147483648.0;  // larger offsets and counts exceed the limit on buffers anyway
    const bool number = value.is_number();
    const double amount = number ? value.get<double>() : -1.0;
    if (!number || !(amount >= 0.0) || amount >= limit || amount != std::floor(amount))
        throw Error(fmt::format("{} is {}, expected an integer from 0 to 2147483647", where, shown(value)));
    value = static_cast<std::uint64_t>(amount);
}

void requireIntegers(Json& values, const std::string& where) {
    if (!values.is_array() && !values.is_object()) throw Error(fmt::format("{} is not a list of indices", where));
    for (Json& value : values) requireInteger(value, where);
}

void requireNumbers(const Json& values, std::size_t count, const std::string& where) {
    bool good = values.is_array() && values.size() == count;
    if (good)
        for (const Json& value : values) good = good && value.is_number();
    if (!good) throw Error(fmt::format("{} is {}, expected a list of {} numbers", where, shown(values), count));
}

/// Recursive; its depth is limited because the nesting of the file is limited.
void checkIntegers(Json& object, const std::string& where) {
    for (auto& item : object.items()) {
        const std::string& key = item.key();
        Json& value = item.value();
        if (key == "extras" || key == "extensions") continue;
        const std::string here = where + "." + oneLine(key, 30);
        if (integerKeys.contains(key) && !value.is_object())
            requireInteger(value, here);
        else if (integerListKeys.contains(key))
            requireIntegers(value, here);
        else if (key == "attributes" || (key == "nodes" && value.is_array()))
            requireIntegers(value, here);
        else if (key == "targets" && value.is_array())
            for (Json& target : value) requireIntegers(target, here);
        else if (value.is_object())
            checkIntegers(value, here);
        else if (value.is_array())
            for (Json& element : value)
                if (element.is_object()) checkIntegers(element, here);
    }
}

void checkNode(Json& node, const std::string& where) {
    const auto check = [&](const char* key, std::size_t count) {
        if (const auto found = node.find(key); found != node.end()) requireNumbers(*found, count, where + "." + key);
    };
    check("translation", 3);
    check("rotation", 4);
    check("scale", 3);
    check("matrix", 16);
    const nlohmann::json::json_pointer light("/extensions/KHR_lights_punctual/light");
    if (node.contains(light)) requireInteger(node[light], where + ".light");
    const nlohmann::json::json_pointer instances("/extensions/EXT_mesh_gpu_instancing/attributes");
    if (node.contains(instances)) requireIntegers(node[instances], where + " instances");
}

}  // namespace

void checkStructure(Json& root) {
    for (const char* section : {"accessors", "animations", "bufferViews", "buffers", "cameras", "images", "materials",
                                "meshes", "nodes", "samplers", "scenes", "skins", "textures"}) {
        const auto found = root.find(section);
        if (found == root.end()) continue;
        if (!found->is_array()) throw Error(fmt::format("{} is not a list", section));
        std::size_t index = 0;
        for (Json& element : *found) {
            const std::string where = fmt::format("{}[{}]", section, index++);
            if (!element.is_object()) throw Error(fmt::format("{} is not an object", where));
            checkIntegers(element, where);
            if (std::string_view(section) == "nodes") checkNode(element, where);
        }
    }
    if (const auto scene = root.find("scene"); scene != root.end()) requireInteger(*scene, "scene");
}

}  // namespace timeshade::gltf
