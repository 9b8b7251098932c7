#pragma once

// Builds small glTF files in memory and writes them to a folder that goes away with the test.

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "support/temporary_folder.h"

namespace timeshade::test {

using Json = nlohmann::json;

/// The JSON of a file and its one buffer.
struct GltfFile {
    Json json = {{"asset", {{"version", "2.0"}}}};
    ByteList data;

    int add(const char* section, Json element) {
        json[section].push_back(std::move(element));
        return static_cast<int>(json[section].size()) - 1;
    }
    int addView(const void* bytes, std::size_t size) {
        while (data.size() % 4 != 0) data.push_back(0);
        const auto offset = data.size();
        data.resize(offset + size);
        if (size > 0) std::memcpy(data.data() + offset, bytes, size);
        return add("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
    }
    template <typename Number>
    int addAccessor(const std::vector<Number>& numbers, const char* type, int components, bool normalized = false) {
        const int componentType = std::is_same_v<Number, float>           ? 5126
                                  : std::is_same_v<Number, std::uint32_t> ? 5125
                                  : std::is_same_v<Number, std::uint16_t> ? 5123
                                  : std::is_same_v<Number, std::int16_t>  ? 5122
                                  : std::is_same_v<Number, std::uint8_t>  ? 5121
                                                                          : 5120;
        Json accessor = {{"bufferView", addView(numbers.data(), numbers.size() * sizeof(Number))},
                         {"componentType", componentType},
                         {"count", numbers.size() / static_cast<std::size_t>(components)},
                         {"type", type}};
        if (normalized) accessor["normalized"] = true;
        return add("accessors", accessor);
    }
    int scalars(const std::vector<float>& v) { return addAccessor(v, "SCALAR", 1); }
    int vec3s(const std::vector<float>& v) { return addAccessor(v, "VEC3", 3); }
    int vec4s(const std::vector<float>& v) { return addAccessor(v, "VEC4", 4); }

    /// A mesh of one primitive.
    int addMesh(Json attributes, int indices = -1, int mode = 4) {
        Json primitive = {{"attributes", std::move(attributes)}, {"mode", mode}};
        if (indices >= 0) primitive["indices"] = indices;
        return add("meshes", {{"primitives", Json::array({primitive})}});
    }
    /// Adds the node and makes it a root of scene 0.
    int addRoot(Json node) {
        const int index = add("nodes", std::move(node));
        json["scenes"][0]["nodes"].push_back(index);
        json["scene"] = 0;
        return index;
    }
    /// Adds a channel to animation 0.
    void animate(int node, const char* path, const std::vector<float>& times, int output,
                 const char* interpolation = "LINEAR") {
        Json& animation = json["animations"][0];
        animation["samplers"].push_back(
            {{"input", scalars(times)}, {"output", output}, {"interpolation", interpolation}});
        animation["channels"].push_back(
            {{"sampler", animation["samplers"].size() - 1}, {"target", {{"node", node}, {"path", path}}}});
    }

    /// JSON and buffer as one .glb. A "buffers" section that is already there is kept.
    ByteList glb() const {
        Json whole = json;
        if (!whole.contains("buffers") && !data.empty())
            whole["buffers"] = Json::array({{{"byteLength", data.size()}}});
        return container(whole.dump(), data);
    }
    static ByteList container(std::string text, ByteList binary) {
        while (text.size() % 4 != 0) text.push_back(' ');
        while (binary.size() % 4 != 0) binary.push_back(0);
        ByteList bytes;
        const auto word = [&](std::size_t value) {
            for (unsigned shift = 0; shift < 32; shift += 8)
                bytes.push_back(static_cast<std::uint8_t>((value >> shift) & 0xffu));
        };
        word(0x46546c67u);
        word(2);
        word(12 + 8 + text.size() + (binary.empty() ? 0 : 8 + binary.size()));
        word(text.size());
        word(0x4e4f534au);
        bytes.insert(bytes.end(), text.begin(), text.end());
        if (binary.empty()) return bytes;
        word(binary.size());
        word(0x004e4942u);
        bytes.insert(bytes.end(), binary.begin(), binary.end());
        return bytes;
    }
    /// The buffer as a file beside the .gltf.
    std::filesystem::path saveSplit(const TemporaryFolder& folder, const std::string& name,
                                    const std::string& uri) const {
        Json whole = json;
        whole["buffers"] = Json::array({{{"byteLength", data.size()}, {"uri", uri}}});
        return folder.write(name, whole.dump());
    }
};

/// One quad in the plane z = 0, from (0,0) to (1,1).
inline int addQuad(GltfFile& file) {
    const int positions = file.vec3s({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    return file.addMesh({{"POSITION", positions}}, file.addAccessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR", 1));
}

/// One pixel, base64.
inline const char* const onePixelPng =
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==";

/// A valid file that has one of everything: node 0 carries a morphing quad that moves, node 1 a joint that turns,
/// node 2 a skinned quad, node 3 a camera, node 4 a light, node 5 a quad with sparse positions.
inline GltfFile fileWithEverything() {
    GltfFile file;
    const int quad = addQuad(file);
    file.json["meshes"][0]["primitives"][0]["targets"] =
        Json::array({{{"POSITION", file.vec3s(std::vector<float>(12, 0.5f))}}});
    file.json["meshes"][0]["weights"] = {0.25};
    file.json["meshes"][0]["primitives"][0]["material"] = 0;
    file.add("images", {{"uri", std::string("data:image/png;base64,") + onePixelPng}});
    file.add("samplers", Json::object());
    file.add("textures", {{"source", 0}, {"sampler", 0}});
    file.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    file.addRoot({{"mesh", quad}});

    file.addRoot({{"name", "joint"}});
    const int joints = file.addAccessor<std::uint8_t>(std::vector<std::uint8_t>(16, 0), "VEC4", 4);
    const int weights = file.vec4s({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    const int positions = file.vec3s({0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1});
    const int skinned = file.addMesh({{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}, 1);
    const int inverse = file.addAccessor<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, "MAT4", 16);
    file.add("skins", {{"joints", {1}}, {"inverseBindMatrices", inverse}});
    file.addRoot({{"mesh", skinned}, {"skin", 0}});

    file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}});
    file.addRoot({{"name", "eye"}, {"camera", 0}, {"translation", {0, 0, 5}}});
    file.json["extensionsUsed"] = {"KHR_lights_punctual"};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] =
        Json::array({{{"type", "spot"}, {"intensity", 100}, {"spot", Json::object()}}});
    file.addRoot({{"translation", {0, 3, 0}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});

    const int sparse = file.vec3s(std::vector<float>(12, 0.0f));
    const std::vector<std::uint8_t> places{1, 2};
    const std::vector<float> values{1, 0, 2, 1, 1, 2};
    file.json["accessors"][static_cast<std::size_t>(sparse)]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", file.addView(places.data(), 2)}, {"componentType", 5121}}},
        {"values", {{"bufferView", file.addView(values.data(), 24)}}}};
    file.addRoot({{"mesh", file.addMesh({{"POSITION", sparse}}, 1)}});

    file.animate(0, "translation", {0, 1, 2}, file.vec3s({0, 0, 0, 2, 0, 0, 0, 0, 0}));
    file.animate(1, "rotation", {0, 2}, file.vec4s({0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f}));
    file.animate(0, "weights", {0, 2}, file.scalars({0, 0, 0, 0, 1, 0}), "CUBICSPLINE");
    return file;
}

}  // namespace timeshade::test
