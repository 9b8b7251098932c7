#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace timeshade::gl {

/// Names and values put as `#define NAME VALUE` after #version: what tells one variant of a shader from another.
using ShaderDefines = std::vector<std::pair<std::string, std::string>>;

/// The text that is handed to the driver: `#version 450 core`, the defines, then the file with its
/// `#include "path"` lines replaced (paths are relative to the shader folder; a file is taken in once). Line
/// numbers of messages are kept true by #line with one number per file, listed in `files`.
struct ShaderSource {
    std::string text;
    std::vector<std::string> files;  ///< files[n] is the file that #line calls n
};

/// Throws Error that names the file which is missing, or too much (256 files, 4 MiB), and who includes it.
ShaderSource readShader(std::string_view path, const ShaderDefines& defines);

/// Where the shaders lie: TIMESHADE_SHADERS where that is set, else dataFolder()/shaders.
std::filesystem::path shaderDirectory();

}  // namespace timeshade::gl
