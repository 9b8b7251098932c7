#include "frame/buffer_check.h"

#include <vector>

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade {

namespace {

struct Readback {
    GLenum format = 0;  ///< 0: not floats
    std::size_t channels = 0;
};

Readback readbackOf(GLenum internalFormat) {
    switch (internalFormat) {
    case GL_R32F: return {GL_RED, 1};
    case GL_RG32F: return {GL_RG, 2};
    case GL_RGBA32F: return {GL_RGBA, 4};
    case GL_DEPTH_COMPONENT32F: return {GL_DEPTH_COMPONENT, 1};
    default: return {};
    }
}

}  // namespace

void requireFinite(const gl::Texture& texture, const std::string& what, float low, float high) {
    const Readback readback = readbackOf(texture.format());
    if (readback.format == 0) return;
    std::vector<float> values(texture.bytes() / sizeof(float));
    glGetTextureImage(texture.name(), 0, readback.format, GL_FLOAT, static_cast<GLsizei>(texture.bytes()),
                      values.data());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] >= low && values[i] <= high) continue;  // false for a NaN
        const std::size_t texel = i / readback.channels, width = static_cast<std::size_t>(texture.width()),
                          height = static_cast<std::size_t>(texture.height());
        throw Error(fmt::format("{}: {} at column {}, row {}, layer {}; expected a number from {:g} to {:g}", what,
                                values[i], texel % width, texel / width % height, texel / (width * height), low, high));
    }
}

}  // namespace timeshade
