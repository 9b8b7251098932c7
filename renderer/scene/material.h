#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace timeshade {

/// How an image goes on beyond its border.
enum class Wrap : std::uint8_t { Repeat, MirroredRepeat, ClampToEdge };

/// What alpha cuts out of a surface (glTF's alphaMode MASK): where alpha is less than the cutoff there is nothing, for
/// eyes and for light (docs/numerics.md, "Cut-outs").
struct Cutout {
    float threshold = 0.0f;  ///< least alpha that covers, in 1/255 of what the image holds; > 0
    int image = -1;          ///< index into Scene::images(), whose alpha counts; -1: 255 everywhere
    Wrap wrapS = Wrap::Repeat, wrapT = Wrap::Repeat;
    bool nearest = false;  ///< one texel counts, the one that holds the place; else four, bilinearly
};

/// Of glTF's numbers: alpha is `factor` times the image's, and covers from `cutoff` on.
float cutoutThreshold(double cutoff, double factor);

/// glTF's metallic-roughness material, linear colour.
struct Material {
    std::string name;
    glm::vec4 baseColorFactor{1.0f};
    float metallicFactor = 1.0f;
    float roughnessFactor = 1.0f;
    glm::vec3 emissiveFactor{0.0f};
    bool doubleSided = false;
    std::optional<Cutout> cutout;     ///< none: it covers wherever its triangles are
    int baseColorImage = -1;          ///< index into Scene::images(), sRGB encoded; -1 for none
    int metallicRoughnessImage = -1;  ///< green: roughness, blue: metalness, linear; -1 for none
};

/// Four channels of eight bits, rows from top to bottom as in glTF.
struct Image {
    std::string name;
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

}  // namespace timeshade
