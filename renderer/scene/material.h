#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace timeshade {

/// What lies beside an image, along one of its sides.
enum class Wrap { Repeat, Mirror, Clamp };

/// An image that a material uses, and how it is read: filtered linearly, over at least half a pixel's footprint.
struct TextureUse {
    int image = -1;       ///< index into Scene::images(); -1 for none
    int coordinates = 0;  ///< 0..2: which of MeshTopology's texture coordinates
    Wrap wrapU = Wrap::Repeat, wrapV = Wrap::Repeat;
};

/// What alpha cuts out of a surface (glTF's alphaMode MASK): where the alpha of its base colour's image is less than
/// the cutoff there is nothing, for eyes and for light (docs/numerics.md, "Cut-outs").
struct Cutout {
    float threshold = 0.0f;  ///< least alpha that covers, in 1/255 of what the image holds (255 without one); > 0
    bool nearest = false;    ///< one texel counts, the one that holds the place; else four, bilinearly
};

/// Of glTF's numbers: alpha is `factor` times the image's, and covers from `cutoff` on.
float cutoutThreshold(double cutoff, double factor);

/// glTF's metallic-roughness material, linear colour.
struct Material {
    std::string name;
    glm::vec4 baseColorFactor{1.0f};
    float metallicFactor = 1.0f;
    float roughnessFactor = 1.0f;
    glm::vec3 emissiveFactor{0.0f};  ///< may be above 1
    bool doubleSided = false;
    TextureUse baseColor;          ///< sRGB encoded; reads coordinates 0
    TextureUse metallicRoughness;  ///< green: roughness, blue: metalness, linear
    TextureUse emissive;           ///< sRGB encoded
    std::optional<Cutout> cutout;  ///< none: it covers wherever its triangles are
};

/// Four channels of eight bits, rows from top to bottom as in glTF.
struct Image {
    std::string name;
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

}  // namespace timeshade
