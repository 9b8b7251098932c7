#include "window/layout.h"

#include <algorithm>

namespace timeshade {

namespace {
// In units of the text's scale.
constexpr float sideWidth = 340.0f, transportHeight = 76.0f, leastPicture = 240.0f, leastPanel = 90.0f;
}  // namespace

Layout layoutOf(ImVec2 window, float scale, bool panelsVisible) {
    Layout layout;
    layout.picture.size = window;
    if (!panelsVisible || window.x < leastPanel * scale || window.y < leastPanel * scale) return layout;
    const float bar = transportHeight * scale;
    const bool wide = window.x >= (sideWidth + leastPicture) * scale;
    const bool tall = window.y >= 3.0f * bar;
    if (wide) {
        layout.side.size = {sideWidth * scale, window.y};
        layout.picture = {{layout.side.size.x, 0.0f}, {window.x - layout.side.size.x, window.y}};
        if (!tall) return layout;
        layout.picture.size.y -= bar;
        layout.transport = {{layout.picture.position.x, layout.picture.size.y}, {layout.picture.size.x, bar}};
        return layout;
    }
    layout.side.size = {std::min(sideWidth * scale, window.x), tall ? window.y - bar : window.y};
    if (tall) layout.transport = {{0.0f, window.y - bar}, {window.x, bar}};
    return layout;
}

}  // namespace timeshade
