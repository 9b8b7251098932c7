#include "window/ui_dump.h"

#include <array>
#include <cstdlib>

#include <imgui.h>

#include "image/image_file.h"

namespace timeshade {

UiDump::UiDump() {
    if (const char* path = std::getenv("TIMESHADE_UI_DUMP")) path_ = path;
}

void UiDump::beginFrame() {
    widgets_ = nlohmann::ordered_json::object();
    state_ = nlohmann::ordered_json::object();
}

void UiDump::lastItem(const std::string& id, const nlohmann::json& value) {
    if (!enabled()) return;
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const auto pixel = [](float x) { return static_cast<int>(x); };
    // In a region that scrolls, an item may reach below its edge.
    const float centre = 0.5f * (low.y + high.y), top = ImGui::GetWindowPos().y;
    const bool inside = centre >= top && centre <= top + ImGui::GetWindowSize().y;
    widgets_[id] = {{"rect", std::array<int, 4>{pixel(low.x), pixel(low.y), pixel(high.x), pixel(high.y)}},
                    {"visible", ImGui::IsItemVisible() && inside},
                    {"value", value}};
}

void UiDump::state(const std::string& key, nlohmann::json value) {
    if (enabled()) state_[key] = std::move(value);
}

void UiDump::endFrame() {
    if (!enabled()) return;
    const nlohmann::ordered_json all{{"state", state_}, {"widgets", widgets_}};
    // Names in a user's file need not be UTF-8.
    std::string text = all.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    if (text == written_) return;
    writeFileAtomically(path_, text);
    written_ = std::move(text);
}

}  // namespace timeshade
