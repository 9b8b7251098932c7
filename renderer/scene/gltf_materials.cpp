#include "scene/gltf_materials.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "core/one_line.h"

namespace timeshade::gltf {

namespace {

float unit(double value, double fallback) {
    return static_cast<float>(std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : fallback);
}

/// A property that is a number, or a list of them; as many as `numbers` has, which it has where it is absent.
template <std::size_t Count>
std::array<double, Count> numbersOf(const tinygltf::Value& object, const char* key, std::array<double, Count> numbers,
                                    const std::string& what) {
    constexpr double most = 1e6;
    if (!object.Has(key)) return numbers;
    const tinygltf::Value& given = object.Get(key);
    bool good = Count == 1 ? given.IsNumber() : given.IsArray() && given.ArrayLen() == Count;
    for (std::size_t i = 0; good && i < Count; ++i) {
        const tinygltf::Value& number = Count == 1 ? given : given.Get(i);
        good = number.IsNumber() && std::abs(number.GetNumberAsDouble()) <= most;
        if (good) numbers[i] = number.GetNumberAsDouble();
    }
    if (!good)
        throw Error(fmt::format("{}: {} is not {} of at most {}", what, key,
                                Count == 1 ? "a number" : fmt::format("a list of {} numbers", Count), most));
    return numbers;
}

/// Which coordinates a texture reads. KHR_texture_transform: scaled, then turned counter-clockwise as the image is seen
/// (v grows downwards), then moved.
CoordinateSource coordinatesOf(int set, const tinygltf::ExtensionMap& extensions, const std::string& what) {
    CoordinateSource source{set};
    const auto place = extensions.find("KHR_texture_transform");
    if (place != extensions.end()) {
        const tinygltf::Value& transform = place->second;
        const auto [x, y] = numbersOf<2>(transform, "offset", {0.0, 0.0}, what);
        const auto [scaleX, scaleY] = numbersOf<2>(transform, "scale", {1.0, 1.0}, what);
        const double turn = numbersOf<1>(transform, "rotation", {0.0}, what)[0];
        const double c = std::cos(turn), s = std::sin(turn);
        source.fromSet = {glm::dvec3(c * scaleX, -s * scaleX, 0.0), glm::dvec3(s * scaleY, c * scaleY, 0.0),
                          glm::dvec3(x, y, 1.0)};
        const double other = numbersOf<1>(transform, "texCoord", {static_cast<double>(set)}, what)[0];
        if (!(other >= 0.0 && other == std::floor(other)))
            throw Error(fmt::format("{}: texCoord is {}, expected the number of a set", what, other));
        source.set = static_cast<int>(other);
    }
    return source;
}

/// Gives a material's texture the coordinates that it reads: equal ones are shared.
template <typename TextureInfo>
void use(const TextureInfo& from, const char* name, MaterialSource& source, TextureUse& to) {
    if (from.index < 0) return;
    to.image = from.index;
    const CoordinateSource wanted =
        coordinatesOf(from.texCoord, from.extensions, fmt::format("material \"{}\" {}", source.material.name, name));
    if (!source.textured) source.coordinates.clear();
    source.textured = true;
    const auto found = std::find(source.coordinates.begin(), source.coordinates.end(), wanted);
    to.coordinates = static_cast<int>(found - source.coordinates.begin());
    if (found == source.coordinates.end()) source.coordinates.push_back(wanted);
}

MaterialSource convert(const tinygltf::Material& from, std::size_t index) {
    MaterialSource to;
    const auto& pbr = from.pbrMetallicRoughness;
    to.material.name = from.name.empty() ? fmt::format("material {}", index) : oneLine(from.name);
    for (int i = 0; i < 4 && pbr.baseColorFactor.size() == 4; ++i)
        to.material.baseColorFactor[i] = unit(pbr.baseColorFactor[static_cast<std::size_t>(i)], 1.0);
    double strength = 1.0;
    if (const auto place = from.extensions.find("KHR_materials_emissive_strength"); place != from.extensions.end())
        strength =
            numbersOf<1>(place->second, "emissiveStrength", {1.0}, fmt::format("material \"{}\"", to.material.name))[0];
    for (int i = 0; i < 3 && from.emissiveFactor.size() == 3; ++i)
        to.material.emissiveFactor[i] =
            unit(from.emissiveFactor[static_cast<std::size_t>(i)], 0.0) * static_cast<float>(std::max(strength, 0.0));
    to.material.metallicFactor = unit(pbr.metallicFactor, 1.0);
    to.material.roughnessFactor = unit(pbr.roughnessFactor, 1.0);
    to.material.doubleSided = from.doubleSided;
    to.cutOut = from.alphaMode == "MASK";
    to.transparent = from.alphaMode != "OPAQUE" && !to.cutOut;
    if (std::isfinite(from.alphaCutoff)) to.alphaCutoff = from.alphaCutoff;
    // In this order, so that the base colour reads coordinates 0.
    use(pbr.baseColorTexture, "baseColorTexture", to, to.material.baseColor);
    use(pbr.metallicRoughnessTexture, "metallicRoughnessTexture", to, to.material.metallicRoughness);
    use(from.emissiveTexture, "emissiveTexture", to, to.material.emissive);
    return to;
}

Wrap wrapOf(int mode, std::size_t& unknown) {
    switch (mode) {
    case TINYGLTF_TEXTURE_WRAP_REPEAT: return Wrap::Repeat;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT: return Wrap::Mirror;
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE: return Wrap::Clamp;
    default: ++unknown; return Wrap::Repeat;
    }
}

void readTextures(const tinygltf::Model& from, Model& to) {
    std::size_t unknown = 0, nearest = 0;
    for (const tinygltf::Texture& texture : from.textures) {
        Texture& read = to.textures.emplace_back();
        read.image = texture.source;
        if (texture.sampler < 0) continue;
        if (static_cast<std::size_t>(texture.sampler) >= from.samplers.size())
            throw Error(fmt::format("texture {} refers to sampler {}, the file has {}", to.textures.size() - 1,
                                    texture.sampler, from.samplers.size()));
        const tinygltf::Sampler& sampler = from.samplers[static_cast<std::size_t>(texture.sampler)];
        read.wrapU = wrapOf(sampler.wrapS, unknown);
        read.wrapV = wrapOf(sampler.wrapT, unknown);
        read.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
        if (read.nearest) ++nearest;
    }
    if (unknown > 0)
        to.notes.push_back(fmt::format("{} samplers wrap in a way that glTF does not know; they repeat", unknown));
    if (nearest > 0)
        to.notes.push_back(fmt::format("{} textures ask for the nearest texel; they are filtered linearly", nearest));
}

}  // namespace

void readMaterials(const tinygltf::Model& from, Model& to) {
    std::size_t shapes = 0;
    for (const tinygltf::Material& material : from.materials) {
        to.materials.push_back(convert(material, to.materials.size()));
        if (material.normalTexture.index >= 0 || material.occlusionTexture.index >= 0) ++shapes;
    }
    if (shapes > 0)
        to.notes.push_back(fmt::format("{} materials have normal or occlusion textures, which are left out", shapes));
    readTextures(from, to);
}

}  // namespace timeshade::gltf
