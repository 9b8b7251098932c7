#pragma once

// Files that are wrong in one way each. All but the first few start as the same valid file.

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "gltf_writer.h"

namespace timeshade::test {

struct BrokenFile {
    std::string name;
    std::string expected;  ///< part of the message
    ByteList bytes;
};

/// The valid file after a change to its JSON or its buffer.
inline ByteList changed(const std::function<void(GltfFile&)>& change) {
    GltfFile file = fileWithEverything();
    change(file);
    return file.glb();
}

inline ByteList cut(ByteList bytes, std::size_t length) {
    bytes.resize(std::min(length, bytes.size()));
    return bytes;
}

/// Overwrites a number in the buffer, at the given element of an accessor.
template <typename Number>
void poke(GltfFile& file, std::size_t accessor, std::size_t element, Number value) {
    const auto view = file.json["accessors"][accessor]["bufferView"].get<std::size_t>();
    const auto offset = file.json["bufferViews"][view]["byteOffset"].get<std::size_t>();
    std::memcpy(file.data.data() + offset + element * sizeof(Number), &value, sizeof value);
}

inline Json& at(GltfFile& file, const char* pointer) { return file.json[Json::json_pointer(pointer)]; }

inline std::vector<BrokenFile> brokenContainers() {
    const ByteList whole = fileWithEverything().glb();
    ByteList badMagic = whole;
    badMagic[0] = 'x';
    ByteList badVersion = whole;
    badVersion[4] = 1;
    ByteList badChunk = whole;
    badChunk[14] = 0xff;
    ByteList badLength = whole;
    badLength[8] = 4;
    badLength[9] = badLength[10] = badLength[11] = 0;
    std::string deep =
        R"({"asset":{"version":"2.0"},"extras":)" + std::string(100'000, '[') + std::string(100'000, ']') + "}";
    const std::string text = fileWithEverything().json.dump();
    return {
        {"empty", "is empty", {}},
        {"magic only", "truncated", cut(whole, 4)},
        {"half a header", "truncated", cut(whole, 15)},
        {"half the JSON", "truncated", cut(whole, 300)},
        {"half the buffer", "truncated", cut(whole, whole.size() - 40)},
        {"bad magic", "neither a .glb nor valid JSON", badMagic},
        {"version 1 container", "version 1, expected 2", badVersion},
        {"chunk past the end", "chunk goes past the end", badChunk},
        {"length of 4", "length of 4 bytes", badLength},
        {"bad JSON in a container", "nor valid JSON", GltfFile::container("{\"asset\":", {})},
        {"truncated text", "nor valid JSON",
         ByteList(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.size() / 2))},
        {"JSON is a list", "not an object", GltfFile::container("[1]", {})},
        {"no asset", "no \"asset\"", GltfFile::container("{}", {})},
        {"glTF 1", "version \"1.0\"", GltfFile::container(R"({"asset":{"version":"1.0"}})", {})},
        {"deep JSON", "nested more than 256", ByteList(deep.begin(), deep.end())},
        {"huge number", "too large", GltfFile::container(R"({"asset":{"version":"2.0"},"extras":1e999})", {})},
        {"no triangles", "no triangles", GltfFile::container(R"({"asset":{"version":"2.0"}})", {})},
        {"empty scene", "no triangles", changed([](GltfFile& f) { at(f, "/scenes/0/nodes") = Json::array(); })},
    };
}

inline std::vector<BrokenFile> brokenIndices() {
    std::vector<BrokenFile> files;
    const auto set = [&](const char* pointer, const Json& value, const char* expected) {
        files.push_back({std::string(pointer) + " = " + value.dump(), expected,
                         changed([&](GltfFile& f) { at(f, pointer) = value; })});
    };
    set("/scene", 7, "scene 7");
    set("/scenes/0/nodes/0", 99, "node 99");
    set("/scenes/0/nodes/0", -1, "expected an integer");
    set("/nodes/0/mesh", 99, "mesh 99");
    set("/nodes/0/mesh", "0", "expected an integer");
    set("/nodes/0/mesh", 0.5, "expected an integer");
    set("/nodes/0/mesh", 4294967296, "expected an integer");
    set("/nodes/2/skin", 5, "skin 5");
    set("/nodes/3/camera", 5, "camera 5");
    set("/nodes/4/extensions/KHR_lights_punctual/light", 5, "light 5");
    set("/nodes/4/extensions/KHR_lights_punctual/light", "x", "expected an integer");
    set("/nodes/0/translation", Json::array({1, 2}), "3 numbers");
    set("/nodes/0/rotation", Json::array({0, 0, 0, "1"}), "4 numbers");
    set("/nodes/0/matrix", Json::array({1, 2, 3}), "16 numbers");
    set("/nodes/0/scale", Json::array({1e30, 1, 1}), "beyond");
    set("/nodes", "none", "nodes is not a list");
    set("/nodes/0", 3, "not an object");
    set("/meshes/0/primitives/0/attributes/POSITION", 99, "accessor 99");
    set("/meshes/0/primitives/0/attributes", 5, "not a list of indices");
    set("/meshes/0/primitives/0/indices", 99, "");
    set("/meshes/0/primitives/0/material", 9, "material 9");
    set("/meshes/0/primitives/0/mode", 12, "mode 12");
    set("/meshes/0/primitives/0/targets/0/POSITION", 99, "accessor 99");
    set("/accessors/0/bufferView", 99, "bufferView 99");
    set("/accessors/0/count", 5000, "bytes of its buffer view");
    set("/accessors/0/count", 2147483647, "bytes of its buffer view");
    set("/accessors/0/count", 0, "count of 0");
    set("/accessors/0/count", -3, "expected an integer");
    set("/accessors/0/byteOffset", 2147483647, "bytes of its buffer view");
    set("/accessors/0/byteOffset", 18446744073709551615u, "expected an integer");
    set("/accessors/0/componentType", 5125, "not allowed");
    set("/accessors/0/componentType", 1, "");
    set("/accessors/0/type", "VEC4", "");
    set("/accessors/0/type", "VEC9", "");
    set("/bufferViews/0/buffer", 3, "buffer 3");
    set("/bufferViews/0/byteOffset", 2147483647, "of a buffer of");
    set("/bufferViews/0/byteLength", 2147483647, "of a buffer of");
    set("/bufferViews/0/byteLength", 0, "no bytes");
    set("/bufferViews/0/byteStride", -4, "expected an integer");
    set("/bufferViews/0/byteStride", 4, "stride of 4");
    set("/bufferViews/0/byteStride", 252, "bytes of its buffer view");
    return files;
}

inline std::vector<BrokenFile> brokenReferences() {
    std::vector<BrokenFile> files;
    const auto set = [&](const char* pointer, const Json& value, const char* expected) {
        files.push_back({std::string(pointer) + " = " + value.dump(), expected,
                         changed([&](GltfFile& f) { at(f, pointer) = value; })});
    };
    set("/skins/0/joints/0", 99, "node 99");
    set("/skins/0/joints", Json::array(), "no joints");
    set("/skins/0/inverseBindMatrices", 99, "accessor 99");
    set("/skins/0/inverseBindMatrices", 0, "4x4");
    set("/animations/0/channels/0/sampler", 99, "sampler 99");
    set("/animations/0/channels/0/target/node", 99, "node 99");
    set("/animations/0/samplers/0/input", 99, "accessor 99");
    set("/animations/0/samplers/0/output", 99, "accessor 99");
    set("/animations/0/samplers/0/interpolation", "BEZIER", "BEZIER");
    set("/textures/0/source", 9, "image 9");
    set("/materials/0/pbrMetallicRoughness/baseColorTexture/index", 9, "texture 9");
    set("/extensionsRequired", Json::array({"KHR_node_visibility"}),
        "needs the glTF extension KHR_node_visibility, which is not supported (supported: ");
    set("/extensionsRequired", Json::array({"VENDOR_secret\nline"}), "VENDOR_secret line");
    set("/extensionsRequired", Json::array({5}), "not a name");
    set("/buffers", Json::array({{{"byteLength", 100'000'000}}}), "needs 100000000 bytes");
    set("/buffers", Json::array({Json::object()}), "no byteLength");
    set("/buffers", Json::array({{{"byteLength", 10}, {"uri", "data:text/plain,hello"}}}), "not base64");
    set("/buffers", Json::array({{{"byteLength", 10}, {"uri", "data:;base64,####"}}}), "not base64");
    return files;
}

/// Adds a file: its name, a part of the message that is expected, and the change that breaks it.
using AddBrokenFile = std::function<void(const char*, const char*, const std::function<void(GltfFile&)>&)>;

inline void addBrokenAnimations(const AddBrokenFile& add) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const auto input = [](GltfFile& f, int sampler) {
        return f.json["animations"][0]["samplers"][static_cast<std::size_t>(sampler)]["input"].get<std::size_t>();
    };
    const auto accessorOf = [](GltfFile& f, const char* pointer) { return at(f, pointer).get<std::size_t>(); };
    add("key times out of order", "do not increase", [&](GltfFile& f) { poke(f, input(f, 0), 1, 5.0f); });
    add("equal key times", "do not increase", [&](GltfFile& f) { poke(f, input(f, 0), 1, 0.0f); });
    add("NaN key time", "not finite", [&](GltfFile& f) { poke(f, input(f, 0), 1, nan); });
    add("negative key time", "before 0", [&](GltfFile& f) { poke(f, input(f, 0), 0, -1.0f); });
    add("NaN key value", "not finite",
        [&](GltfFile& f) { poke(f, accessorOf(f, "/animations/0/samplers/0/output"), 2, nan); });
    add("too few key values", "numbers for 3 keys", [](GltfFile& f) {
        at(f, "/animations/0/samplers/0/output") = f.vec3s({0, 0, 0});
    });
    add("spline without tangents", "numbers for 2 keys, expected 6", [](GltfFile& f) {
        at(f, "/animations/0/samplers/2/output") = f.scalars({0, 1});
    });
    add("translation from a rotation's keys", "components",
        [](GltfFile& f) { at(f, "/animations/0/samplers/0/output") = at(f, "/animations/0/samplers/1/output"); });
}

inline std::vector<BrokenFile> brokenContents() {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    std::vector<BrokenFile> files;
    const auto add = [&](const char* name, const char* expected, const std::function<void(GltfFile&)>& change) {
        files.push_back({name, expected, changed(change)});
    };
    const auto accessorOf = [](GltfFile& f, const char* pointer) { return at(f, pointer).get<std::size_t>(); };
    add("NaN position", "not finite", [&](GltfFile& f) { poke(f, 0, 4, nan); });
    add("infinite position", "not finite", [&](GltfFile& f) { poke(f, 0, 4, infinity); });
    add("position of 1e30", "beyond", [&](GltfFile& f) { poke(f, 0, 4, 1e30f); });
    add("NaN morph", "not finite",
        [&](GltfFile& f) { poke(f, accessorOf(f, "/meshes/0/primitives/0/targets/0/POSITION"), 1, nan); });
    add("index beyond the vertices", "index 4 is beyond", [&](GltfFile& f) { poke<std::uint16_t>(f, 1, 2, 4); });
    add("index 65535", "beyond", [&](GltfFile& f) { poke<std::uint16_t>(f, 1, 0, 65535); });
    add("NaN weight", "not finite",
        [&](GltfFile& f) { poke(f, accessorOf(f, "/meshes/1/primitives/0/attributes/WEIGHTS_0"), 0, nan); });
    add("joint beyond the skin", "follows joint 200", [&](GltfFile& f) {
        poke<std::uint8_t>(f, accessorOf(f, "/meshes/1/primitives/0/attributes/JOINTS_0"), 0, 200);
    });
    add("float joints", "not allowed", [&](GltfFile& f) {
        at(f, "/meshes/1/primitives/0/attributes/JOINTS_0") = at(f, "/meshes/1/primitives/0/attributes/WEIGHTS_0");
    });
    add("NaN inverse bind matrix", "not finite",
        [&](GltfFile& f) { poke(f, accessorOf(f, "/skins/0/inverseBindMatrices"), 5, nan); });
    add("too few inverse bind matrices", "1 inverse bind matrices for 2 joints", [](GltfFile& f) {
        at(f, "/skins/0/joints") = {1, 0};
    });
    add("fewer weights than vertices", "elements for", [](GltfFile& f) {
        at(f, "/meshes/1/primitives/0/attributes/WEIGHTS_0") = f.vec4s({1, 0, 0, 0});
    });
    add("fewer normals than vertices", "elements for", [](GltfFile& f) {
        at(f, "/meshes/0/primitives/0/attributes/NORMAL") = f.vec3s({0, 0, 1});
    });
    add("shorter morph target", "elements for", [](GltfFile& f) {
        at(f, "/meshes/0/primitives/0/targets/0/POSITION") = f.vec3s({0, 0, 1});
    });
    add("morph weights without targets", "morph weights", [](GltfFile& f) { at(f, "/meshes/0/weights") = {1, 2, 3}; });
    add("primitives with different targets", "different numbers of morph targets", [](GltfFile& f) {
        Json plain = at(f, "/meshes/0/primitives/0");
        plain.erase("targets");
        at(f, "/meshes/0/primitives").push_back(plain);
    });
    addBrokenAnimations(add);
    return files;
}

inline void addTooLargeFiles(const AddBrokenFile& add) {
    add("a million instances of a large mesh", "which is the limit", [](GltfFile& f) {
        f = GltfFile{};
        std::vector<float> many(3 * 30'000);
        f.addMesh({{"POSITION", f.vec3s(many)}});
        for (int i = 0; i < 3000; ++i) f.addRoot({{"mesh", 0}});
    });
    add("ten thousand morph targets that are one", "vertices of morph targets", [](GltfFile& f) {
        f = GltfFile{};
        std::vector<float> many(3 * 30'000);
        f.addMesh({{"POSITION", f.vec3s(many)}});
        for (int i = 0; i < 10'000; ++i) at(f, "/meshes/0/primitives/0/targets").push_back({{"POSITION", 0}});
        f.addRoot({{"mesh", 0}});
    });
}

inline std::vector<BrokenFile> brokenShapes() {
    std::vector<BrokenFile> files;
    const auto add = [&](const char* name, const char* expected, const std::function<void(GltfFile&)>& change) {
        files.push_back({name, expected, changed(change)});
    };
    add("own child", "its own child", [](GltfFile& f) { at(f, "/nodes/0/children") = {0}; });
    add("cycle", "cycle", [](GltfFile& f) {
        at(f, "/nodes/0/children") = {1};
        at(f, "/nodes/1/children") = {0};
    });
    add("two parents", "two parents", [](GltfFile& f) {
        at(f, "/nodes/0/children") = {2};
        at(f, "/nodes/1/children") = {2};
    });
    add("sparse index beyond", "sparse index 9", [](GltfFile& f) {
        const auto view = f.json["accessors"].size();
        for (std::size_t i = 0; i < view; ++i)
            if (f.json["accessors"][i].contains("sparse"))
                f.data[f.json["bufferViews"][f.json["accessors"][i]["sparse"]["indices"]["bufferView"]
                                                 .get<std::size_t>()]["byteOffset"]
                           .get<std::size_t>()] = 9;
    });
    add("more sparse values than elements", "sparse", [](GltfFile& f) {
        for (Json& accessor : f.json["accessors"])
            if (accessor.contains("sparse")) accessor["sparse"]["count"] = 2'000'000'000;
    });
    add("billions of zeros", "without data", [](GltfFile& f) {
        at(f, "/accessors/0").erase("bufferView");
        at(f, "/accessors/0/count") = 2'000'000'000;
    });
    add("overflowing scales", "overflows", [](GltfFile& f) {
        for (int i = 0; i < 6; ++i) f.addRoot({{"scale", {1e17, 1e17, 1e17}}});
        const auto first = static_cast<int>(f.json["nodes"].size()) - 6;
        for (int i = 0; i < 5; ++i) f.json["nodes"][static_cast<std::size_t>(first + i)]["children"] = {first + i + 1};
    });
    add("all in one point", "no size", [](GltfFile& f) {
        f = GltfFile{};
        addQuad(f);
        f.addRoot({{"mesh", 0}, {"scale", {0, 0, 0}}});
    });
    add("lines only", "no triangles", [](GltfFile& f) {
        f = GltfFile{};
        addQuad(f);
        at(f, "/meshes/0/primitives/0/mode") = 1;
        f.addRoot({{"mesh", 0}});
    });
    addTooLargeFiles(add);
    return files;
}

}  // namespace timeshade::test
