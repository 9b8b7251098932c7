#pragma once

#include <imgui.h>

namespace timeshade {

/// Colours that panels use by meaning.
namespace theme {
inline const ImVec4 canvas{0.055f, 0.060f, 0.070f, 1.0f};  ///< behind the picture
inline const ImVec4 text{0.88f, 0.90f, 0.92f, 1.0f};
inline const ImVec4 quiet{0.60f, 0.64f, 0.69f, 1.0f};  ///< what explains something else
inline const ImVec4 accent{0.44f, 0.69f, 0.93f, 1.0f};
inline const ImVec4 warning{0.96f, 0.75f, 0.36f, 1.0f};
inline const ImVec4 bad{0.97f, 0.52f, 0.47f, 1.0f};
}  // namespace theme

/// Sets ImGui's style anew for lengths multiplied by `scale`.
void applyTheme(float scale);

}  // namespace timeshade
