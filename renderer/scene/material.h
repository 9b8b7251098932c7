#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace timeshade {

/// glTF's metallic-roughness material, linear colour.
struct Material {
    std::string name;
    glm::vec4 baseColorFactor{1.0f};
    float metallicFactor = 1.0f;
    float roughnessFactor = 1.0f;
    glm::vec3 emissiveFactor{0.0f};
    bool doubleSided = false;
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
