#include "panels/comparison_view.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "panels/theme.h"

namespace timeshade {

namespace {

ImTextureID idOf(const gl::Texture& texture) {
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture.name()));
}

/// The shares [from, to) of a picture's width at [left, right) of the area's. OpenGL's rows go upwards.
void drawPart(const gl::Texture& texture, const Area& area, float left, float right, float from, float to) {
    const auto x = [&](float share) { return area.position.x + std::round(share * area.size.x); };
    ImGui::GetBackgroundDrawList()->AddImage(idOf(texture), {x(left), area.position.y},
                                             {x(right), area.position.y + area.size.y}, {from, 1.0f}, {to, 0.0f});
}

void drawSeam(const Area& area, float share) {
    const float x = area.position.x + std::round(share * area.size.x);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled({x - 2.0f, area.position.y}, {x + 2.0f, area.position.y + area.size.y},
                       IM_COL32(20, 20, 24, 255));
    list.AddRectFilled({x - 1.0f, area.position.y}, {x + 1.0f, area.position.y + area.size.y},
                       IM_COL32(245, 245, 245, 255));
}

/// A label at the upper edge of [left, right], cut off where there is no room.
void drawLabel(const std::string& text, float left, float right, float top, bool atRight, Widgets& widgets,
               const std::string& id) {
    const float pad = 7.0f * widgets.scale();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float width = std::min(size.x + 2.0f * pad, right - left - 2.0f * pad);
    if (width < 4.0f * pad) return;
    const float x = atRight ? right - pad - width : left + pad;
    const ImVec2 corner{x, top + pad}, end{x + width, top + pad + size.y + pad};
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(corner, end, IM_COL32(12, 12, 14, 190), 3.0f * widgets.scale());
    list.PushClipRect(corner, end, true);
    list.AddText({corner.x + pad, corner.y + 0.5f * pad}, ImGui::GetColorU32(theme::text), text.c_str());
    list.PopClipRect();
    widgets.dump().state("compare." + id, text);
}

}  // namespace

void drawComparison(Session& session, Widgets& widgets, const Area& area) {
    Comparison& comparison = session.comparison;
    const gl::Texture* first = session.driver.picture();
    const gl::Texture* second = comparison.picture();
    if (first == nullptr || second == nullptr) return;
    const float left = area.position.x, right = area.position.x + area.size.x, top = area.position.y;
    const std::string ofFirst = comparison.label(session, false), ofSecond = comparison.label(session, true);
    if (comparison.flip || comparison.flipped) {
        drawPart(comparison.flipped ? *second : *first, area, 0.0f, 1.0f, 0.0f, 1.0f);
        drawLabel(comparison.flipped ? ofSecond : ofFirst, left, right, top, comparison.flipped, widgets,
                  comparison.flipped ? "second" : "first");
    } else if (comparison.mode == CompareMode::Difference) {
        // Its rows go downwards.
        if (const gl::Texture* difference = comparison.difference())
            ImGui::GetBackgroundDrawList()->AddImage(idOf(*difference), area.position,
                                                     {right, area.position.y + area.size.y});
        else
            drawPart(*first, area, 0.0f, 1.0f, 0.0f, 1.0f);
        const float middle = left + 0.5f * area.size.x;
        drawLabel(comparison.difference() != nullptr ? "4 x |" + ofFirst : ofFirst, left, middle, top, false, widgets,
                  "first");
        drawLabel(comparison.difference() != nullptr ? "- " + ofSecond + "|" : "waiting for " + ofSecond, middle, right,
                  top, true, widgets, "second");
    } else {
        const bool side = comparison.mode == CompareMode::Side;
        const float seam = side ? 0.5f : static_cast<float>(comparison.seam);
        drawPart(*first, area, 0.0f, seam, side ? 0.25f : 0.0f, side ? 0.75f : seam);
        drawPart(*second, area, seam, 1.0f, side ? 0.25f : seam, side ? 0.75f : 1.0f);
        drawSeam(area, seam);
        const float x = left + seam * area.size.x;
        drawLabel(ofFirst, left, x, top, false, widgets, "first");
        drawLabel(ofSecond, x, right, top, true, widgets, "second");
    }
}

}  // namespace timeshade
