#pragma once

#include <string>
#include <utility>
#include <vector>

namespace timeshade {

/// What the GLSL reference compiler says of a program.
struct ShaderVerdict {
    bool good = false;
    std::string words;  ///< its messages
};

/// Compiles each stage as desktop OpenGL (not Vulkan) and links them. Stages: "vert", "frag", "comp", each with its
/// whole text. A stage of another name is a failed verdict.
ShaderVerdict validateShaders(const std::vector<std::pair<std::string, std::string>>& stages);

}  // namespace timeshade
