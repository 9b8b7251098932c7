#include "frame/buffer_check.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"
#include "gl/read_back.h"

namespace timeshade {

namespace {

struct Readback {
    GLenum format = 0;  ///< 0: not floats
    int channels = 0;
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

/// Floats read at a time. Little enough to stay in the caches: a buffer as large as the texture costs more to come by
/// than to look through.
constexpr int floatsAtATime = 1 << 16;

}  // namespace

void requireFinite(const gl::Texture& texture, const std::string& what, float low, float high) {
    const Readback readback = readbackOf(texture.format());
    if (readback.format == 0 || texture.bytes() == 0) return;
    const int width = texture.width(), perRow = width * readback.channels;
    const int rowsAtATime = std::max(1, floatsAtATime / perRow);
    std::vector<float> values(static_cast<std::size_t>(perRow) * static_cast<std::size_t>(rowsAtATime));
    for (int layer = 0; layer < texture.layers(); ++layer)
        for (int row = 0; row < texture.height(); row += rowsAtATime) {
            const int rows = std::min(rowsAtATime, texture.height() - row);
            gl::readTexels(texture, {0, row, layer, width, rows}, readback.format, GL_FLOAT, values);
            for (int i = 0; i < rows * perRow; ++i) {
                const float value = values[static_cast<std::size_t>(i)];
                if (value >= low && value <= high) continue;  // false for a NaN
                throw Error(fmt::format("{}: {} at column {}, row {}, layer {}; expected a number from {:g} to {:g}",
                                        what, value, i % perRow / readback.channels, row + i / perRow, layer, low,
                                        high));
            }
        }
}

}  // namespace timeshade
