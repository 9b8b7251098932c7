#pragma once

#include <imgui.h>

namespace timeshade {

struct Area {
    ImVec2 position{0.0f, 0.0f};
    ImVec2 size{0.0f, 0.0f};
    bool empty() const { return size.x <= 0.0f || size.y <= 0.0f; }
};

/// Where things are in a window, in ImGui's units. Side panel, transport bar and picture do not overlap while there
/// is room; in a very small window the picture has all of it and lies behind them.
struct Layout {
    Area side, transport, picture;
};

/// `sideWidth` in units of the text's scale, 0 for the one at a first start: as wide as there is room for beside the
/// picture.
Layout layoutOf(ImVec2 window, float scale, bool panelsVisible, float sideWidth = 0.0f);

}  // namespace timeshade
