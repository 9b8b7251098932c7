#pragma once

#include <cstddef>
#include <vector>

namespace timeshade {

/// RGBA as OpenGL has it, rows upwards, to a picture's RGB, rows downwards, times `factor`.
template <typename T, typename Source>
void copyRowsUpsideDown(const std::vector<Source>& rgba, int width, int height, std::vector<T>& rgb, Source factor) {
    rgb.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    auto* out = rgb.data();
    for (int y = height - 1; y >= 0; --y) {
        const Source* in = rgba.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width) * 4;
        for (int x = 0; x < width; ++x, in += 4)
            for (int c = 0; c < 3; ++c) *out++ = static_cast<T>(in[c] * factor);
    }
}

}  // namespace timeshade
