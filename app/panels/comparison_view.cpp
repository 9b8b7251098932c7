#include "panels/comparison_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "panels/fitting_text.h"
#include "panels/imgui_versions.h"
#include "panels/theme.h"

namespace timeshade {

namespace {

/// The shares [from, to) of a picture's width at [left, right) of the area's. OpenGL's rows go upwards.
void drawPart(const gl::Texture& texture, const Area& area, float left, float right, float from, float to,
              bool rowsDown = false) {
    const auto x = [&](float share) { return area.position.x + std::round(share * area.size.x); };
    ImGui::GetBackgroundDrawList()->AddImage(imguiId(texture), {x(left), area.position.y},
                                             {x(right), area.position.y + area.size.y}, {from, rowsDown ? 0.0f : 1.0f},
                                             {to, rowsDown ? 1.0f : 0.0f});
}

void drawSeam(const Area& area, float share) {
    const float x = area.position.x + std::round(share * area.size.x);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled({x - 2.0f, area.position.y}, {x + 2.0f, area.position.y + area.size.y},
                       IM_COL32(20, 20, 24, 255));
    list.AddRectFilled({x - 1.0f, area.position.y}, {x + 1.0f, area.position.y + area.size.y},
                       IM_COL32(245, 245, 245, 255));
}

/// A label at the upper edge of [left, right]; where there is no room, what stands first in it, and `ending`.
void drawLabel(const std::string& whole, float left, float right, float top, bool atRight, Widgets& widgets,
               const std::string& id, const std::string& ending = {}) {
    const float pad = 7.0f * widgets.scale();
    widgets.dump().state("compare." + id, whole + ending);
    const std::string text = fittingText(whole, ending, right - left - 4.0f * pad);
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
}

std::string inWords(const std::array<int, 3>& levels) {
    return fmt::format("{} {} {}", levels[0], levels[1], levels[2]);
}

/// The pixel under the mouse: "A 1 2 3", "B 4 5 6" and how far they are apart; nothing beside the picture.
std::vector<std::string> pixelInWords(const Session& session, const PictureDifference& difference, const Area& area) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (ImGui::GetIO().WantCaptureMouse || !ImGui::IsMousePosValid(&mouse)) return {};
    const FrameRequest& request = session.moment.request;
    const auto pixel = [](float at, float from, float size, int pixels) {
        return static_cast<int>(std::floor((at - from) / std::max(size, 1.0f) * static_cast<float>(pixels)));
    };
    const auto found = difference.at(pixel(mouse.x, area.position.x, area.size.x, request.width),
                                     pixel(mouse.y, area.position.y, area.size.y, request.height));
    if (!found) return {};
    return {"A " + inWords(found->first), "B " + inWords(found->second), "apart " + inWords(found->apart)};
}

/// Which difference is how bright, and the pixel under the mouse, in levels of 255.
void drawLegend(const Session& session, Widgets& widgets, const Area& area) {
    const PictureDifference& difference = *session.comparison.difference();
    const float unit = widgets.scale(), pad = 7.0f * unit, height = 9.0f * unit, line = ImGui::GetTextLineHeight();
    const bool narrow = area.size.x < 360.0f * unit;
    const float bar = (narrow ? 50.0f : 120.0f) * unit;
    const std::string most = fmt::format("{:.3g} of 255 levels apart", 255.0 / difference.gain());
    const std::vector<std::string> pixel = pixelInWords(session, difference, area);
    const std::string inOneRow = fmt::format("{}", fmt::join(pixel, "   "));
    widgets.dump().state("compare.legend", most);
    widgets.dump().state("compare.pixel", inOneRow);
    std::vector<std::string> rows{narrow ? most.substr(0, most.find(" of")) : most};
    if (narrow)
        rows.insert(rows.end(), pixel.begin(), pixel.end());
    else if (!pixel.empty())
        rows.push_back(inOneRow);
    const float indent = line + bar + pad;  // of the first row's text
    float width = indent + ImGui::CalcTextSize(rows.front().c_str()).x;
    for (std::size_t i = 1; i < rows.size(); ++i) width = std::max(width, ImGui::CalcTextSize(rows[i].c_str()).x);
    const ImVec2 end{area.position.x + area.size.x - pad, area.position.y + area.size.y - pad};
    const ImVec2 corner{end.x - width - 2.0f * pad, end.y - static_cast<float>(rows.size()) * line - pad};
    if (corner.x < area.position.x || corner.y < area.position.y + 3.0f * line) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(corner, end, IM_COL32(12, 12, 14, 215), 3.0f * unit);
    const ImU32 text = ImGui::GetColorU32(theme::text), black = IM_COL32(0, 0, 0, 255),
                white = IM_COL32(255, 255, 255, 255);
    const float left = corner.x + pad, top = corner.y + 0.5f * pad;
    list.AddText({left, top}, text, "0");
    const float from = left + line, middle = top + 0.5f * (line - height);
    list.AddRectFilledMultiColor({from, middle}, {from + bar, middle + height}, black, white, white, black);
    list.AddRect({from, middle}, {from + bar, middle + height}, IM_COL32(120, 120, 125, 255));
    for (std::size_t i = 0; i < rows.size(); ++i)
        list.AddText({i == 0 ? left + indent : left, top + static_cast<float>(i) * line}, text, rows[i].c_str());
}

/// Until the difference is known, the first picture.
void drawDifference(Session& session, Widgets& widgets, const Area& area, const std::string& ofFirst,
                    const std::string& ofSecond) {
    const PictureDifference* difference = session.comparison.difference();
    const float left = area.position.x, right = left + area.size.x, top = area.position.y;
    if (difference != nullptr)
        ImGui::GetBackgroundDrawList()->AddImage(imguiId(difference->picture()), area.position,
                                                 {right, area.position.y + area.size.y});
    else
        drawPart(*session.driver.picture(), area, 0.0f, 1.0f, 0.0f, 1.0f);
    const float middle = left + 0.5f * area.size.x;
    drawLabel(difference != nullptr ? fmt::format("{} x |{}", difference->gain(), ofFirst) : ofFirst, left, middle, top,
              false, widgets, "first");
    drawLabel((difference != nullptr ? "- " : "waiting for ") + ofSecond, middle, right, top, true, widgets, "second",
              difference != nullptr ? "|" : "");
    if (difference != nullptr) drawLegend(session, widgets, area);
}

}  // namespace

void drawComparison(Session& session, Widgets& widgets, const Area& area) {
    Comparison& comparison = session.comparison;
    const gl::Texture* first = session.driver.picture();
    const gl::Texture* second = comparison.picture();
    if (first == nullptr) return;
    const float left = area.position.x, right = area.position.x + area.size.x, top = area.position.y;
    const std::string ofFirst = comparison.label(session, false);
    if (second == nullptr) {  // a file of another size
        drawPart(*first, area, 0.0f, 1.0f, 0.0f, 1.0f);
        if (!comparison.complaint().empty())
            drawLabel(comparison.complaint(), left, right, top, true, widgets, "second");
        return;
    }
    const std::string ofSecond = comparison.label(session, true);
    const bool rowsDown = comparison.rowsDown();
    if (comparison.flip || comparison.flipped) {
        const bool shown = comparison.flipped;
        drawPart(shown ? *second : *first, area, 0.0f, 1.0f, 0.0f, 1.0f, shown && rowsDown);
        drawLabel(shown ? ofSecond : ofFirst, left, right, top, shown, widgets, shown ? "second" : "first");
    } else if (comparison.mode == CompareMode::Difference) {
        drawDifference(session, widgets, area, ofFirst, ofSecond);
    } else {
        const bool side = comparison.mode == CompareMode::Side;
        const float seam = side ? 0.5f : static_cast<float>(comparison.seam);
        drawPart(*first, area, 0.0f, seam, side ? 0.25f : 0.0f, side ? 0.75f : seam);
        drawPart(*second, area, seam, 1.0f, side ? 0.25f : seam, side ? 0.75f : 1.0f, rowsDown);
        drawSeam(area, seam);
        const float x = left + seam * area.size.x;
        drawLabel(ofFirst, left, x, top, false, widgets, "first");
        drawLabel(ofSecond, x, right, top, true, widgets, "second");
    }
}

}  // namespace timeshade
