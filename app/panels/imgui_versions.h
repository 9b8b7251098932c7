#pragma once

#include <cstdint>

#include <imgui.h>

#include "gl/texture.h"

// What versions of Dear ImGui, from 1.86 on, say in different ways.

namespace timeshade {

/// A texture of OpenGL's as it is handed to Dear ImGui.
inline ImTextureID imguiId(const gl::Texture& texture) {
#if IMGUI_VERSION_NUM >= 19140
    return static_cast<ImTextureID>(texture.name());
#else
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture.name()));
#endif
}

/// Where the content of the current window ends on the right, as its cursor counts.
inline float contentRight() {
#if IMGUI_VERSION_NUM >= 19110
    return ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
#else
    return ImGui::GetWindowContentRegionMax().x;
#endif
}

/// A font at the size that it was loaded with.
inline void pushFont(ImFont* font) {
#if IMGUI_VERSION_NUM >= 19200
    ImGui::PushFont(font, font->LegacySize);
#else
    ImGui::PushFont(font);
#endif
}

}  // namespace timeshade
