// Writes the models that fuzzing begins with into a folder: fuzz_seeds FOLDER.
#include <cstddef>
#include <filesystem>
#include <string>

#include "../broken_gltf/compressed_files.h"

namespace {

using namespace timeshade::test;

std::string base64(const ByteList& bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63u] : '=';
    }
    return text;
}

void write(const std::filesystem::path& path, const ByteList& bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// Vertex colours, textures with coordinates of their own, and what pointers drive.
GltfFile fileWithLooks() {
    GltfFile file = fileWithEverything();
    Json& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["COLOR_0"] = file.addAccessor<std::uint8_t>(std::vector<std::uint8_t>(16, 100), "VEC4", 4, true);
    attributes["TEXCOORD_0"] = file.addAccessor<float>({0, 0, 1, 0, 1, 1, 0, 1}, "VEC2", 2);
    attributes["TEXCOORD_1"] = file.addAccessor<std::uint16_t>({0, 0, 9, 0, 9, 9, 0, 9}, "VEC2", 2, true);
    file.json["samplers"][0] = {{"wrapS", 33071}, {"wrapT", 33648}};
    Json& material = file.json["materials"][0];
    material["emissiveFactor"] = {1, 0.5, 0};
    material["emissiveTexture"] = {{"index", 0}, {"texCoord", 1}};
    material["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 3}};
    material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
        {"offset", {0.5, 0}}, {"rotation", 1}, {"scale", {2, 2}}};
    for (const char* property : {"intensity", "range", "spot/outerConeAngle"}) {
        file.animate(0, "translation", {0, 1}, file.scalars({1, 1.25f}));
        file.json["animations"][0]["channels"].back()["target"] = {
            {"path", "pointer"},
            {"extensions",
             {{"KHR_animation_pointer",
               {{"pointer", std::string("/extensions/KHR_lights_punctual/lights/0/") + property}}}}}};
    }
    return file;
}

}  // namespace

int main(int argumentCount, char** arguments) {
    if (argumentCount != 2) return 2;
    const std::filesystem::path folder = arguments[1];
    const GltfFile file = fileWithEverything();
    write(folder / "everything.glb", file.glb());
    Json whole = file.json;
    whole["buffers"] = Json::array(
        {{{"byteLength", file.data.size()}, {"uri", "data:application/octet-stream;base64," + base64(file.data)}}});
    const std::string text = whole.dump();
    write(folder / "everything.gltf", ByteList(text.begin(), text.end()));
    write(folder / "looks.glb", fileWithLooks().glb());
    const Grid grid(3);
#ifdef TIMESHADE_MESHOPT
    for (const bool list : {false, true})
        write(folder / (list ? "meshopt-list.glb" : "meshopt.glb"), meshoptFile(grid, list, 4).glb());
#endif
#ifdef TIMESHADE_DRACO
    for (const int speed : {0, 5, 10})
        write(folder / ("draco-" + std::to_string(speed) + ".glb"),
              dracoFile(grid, dracoStream(grid, speed, 11)).glb());
#endif
    return 0;
}
