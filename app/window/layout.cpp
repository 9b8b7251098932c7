#include "window/layout.h"

#include <algorithm>

namespace timeshade {

namespace {
// In units of the text's scale.
constexpr float firstSide = 340.0f, leastSide = 200.0f, transportHeight = 76.0f, leastPicture = 200.0f,
                leastPanel = 90.0f;
}  // namespace

Layout layoutOf(ImVec2 window, float scale, bool panelsVisible, float sideWidth) {
    Layout layout;
    layout.picture.size = window;
    if (!panelsVisible || window.x < leastPanel * scale || window.y < leastPanel * scale) return layout;
    const float bar = transportHeight * scale;
    const bool tall = window.y >= 3.0f * bar;
    const float wanted = std::max(sideWidth > 0.0f ? sideWidth : firstSide, leastSide) * scale;
    if (window.x >= (leastSide + leastPicture) * scale) {
        const float side = std::min(wanted, std::max(leastSide * scale, window.x - 1.4f * leastPicture * scale));
        layout.side.size = {side, window.y};
        layout.picture = {{side, 0.0f}, {window.x - side, window.y}};
        if (!tall) return layout;
        layout.picture.size.y -= bar;
        layout.transport = {{side, layout.picture.size.y}, {layout.picture.size.x, bar}};
        return layout;
    }
    layout.side.size = {std::min(wanted, window.x), tall ? window.y - bar : window.y};
    if (tall) layout.transport = {{0.0f, window.y - bar}, {window.x, bar}};
    return layout;
}

}  // namespace timeshade
