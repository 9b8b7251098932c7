#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "panels/imgui_versions.h"
#include "panels/panels.h"
#include "panels/theme.h"

namespace timeshade {

namespace {

constexpr float stripWidth = 160.0f, valueHeight = 11.0f, truthHeight = 5.0f;
constexpr float thinnestMark = 3.0f, widestMark = 6.0f;  // of an instant, with the gap beside it

/// Bars of one strip: black is shadowed, white is lit.
void drawBars(const PixelProbe::Row& row, float ProbeValue::*shown, ImVec2 corner, ImVec2 size, float mark) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const ProbeBar& bar : barsOf(row.values, shown, mark / size.x)) {
        const auto grey = static_cast<int>(std::lround(255.0f * std::clamp(bar.grey, 0.0f, 1.0f)));
        const float gap = bar.right < 1.0f ? 1.0f : 0.0f;  // to what follows
        list.AddRectFilled({corner.x + size.x * bar.left, corner.y + size.y * bar.top},
                           {corner.x + size.x * bar.right - gap, corner.y + size.y * bar.bottom},
                           IM_COL32(grey, grey, grey, 255));
    }
}

/// The technique's values above the truth over the same intervals, the means of both, and the name.
void drawRow(const PixelProbe::Row& row, Widgets& widgets) {
    const float unit = widgets.scale(), width = stripWidth * unit;
    const float mark =
        unit * std::clamp(0.5f * stripWidth / static_cast<float>(row.values.size()), thinnestMark, widestMark);
    const float height = (valueHeight + 1.0f + truthHeight) * unit;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    // The ground shows where there is no value, and parts dark bars from each other and from the panel.
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x - 1.0f, corner.y - 1.0f},
                                              {corner.x + width + 1.0f, corner.y + height + 1.0f},
                                              IM_COL32(58, 64, 84, 255));
    drawBars(row, &ProbeValue::lit, corner, {width, valueHeight * unit}, mark);
    drawBars(row, &ProbeValue::truth, {corner.x, corner.y + (valueHeight + 1.0f) * unit}, {width, truthHeight * unit},
             mark);
    ImGui::Dummy({width, height});
    std::vector<std::array<float, 4>> values;
    for (const ProbeValue& value : row.values) values.push_back({value.from, value.to, value.lit, value.truth});
    widgets.dump().lastItem("probe." + row.name, values);
    ImGui::SameLine();
    ImGui::Text("%.2f", row.mean(&ProbeValue::lit));
    ImGui::SameLine();
    ImGui::TextColored(theme::quiet, "%.2f", row.mean(&ProbeValue::truth));
    ImGui::SameLine();
    ImGui::TextUnformatted(row.title.c_str());
}

/// Of a triangle's number: neighbours differ.
ImU32 colorOf(std::uint32_t triangle) {
    ImVec4 color(0.0f, 0.0f, 0.0f, 1.0f);
    const float turns = 0.618034f * static_cast<float>(triangle % 4096);
    ImGui::ColorConvertHSVtoRGB(turns - std::floor(turns), 0.55f, 0.9f, color.x, color.y, color.z);
    return ImGui::GetColorU32(color);
}

/// What the pixel's centre sees over the shutter, a colour a triangle, above how much of each segment is lit.
void drawSegments(const std::vector<LitSegment>& segments, Widgets& widgets) {
    const float unit = widgets.scale(), width = stripWidth * unit, middle = (valueHeight + 1.0f) * unit;
    const float height = middle + truthHeight * unit;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({corner.x - 1.0f, corner.y - 1.0f}, {corner.x + width + 1.0f, corner.y + height + 1.0f},
                       IM_COL32(58, 64, 84, 255));
    ImGui::Dummy({width, height});
    const float at = (ImGui::GetMousePos().x - corner.x) / width;
    std::vector<std::array<double, 4>> values;
    for (const LitSegment& segment : segments) {
        const auto [triangle, u0, u1] = segment.seen;
        const double lit = segment.tested > 0.0 ? segment.lit / segment.tested : -1.0;
        values.push_back({triangle == NO_TRIANGLE ? -1.0 : static_cast<double>(triangle), u0, u1, lit});
        if (triangle == NO_TRIANGLE) continue;
        const float left = corner.x + width * static_cast<float>(u0), right = corner.x + width * static_cast<float>(u1);
        list.AddRectFilled({left, corner.y}, {right, corner.y + valueHeight * unit}, colorOf(triangle));
        const auto grey = static_cast<int>(std::lround(255.0 * std::clamp(lit, 0.0, 1.0)));
        if (lit >= 0.0)
            list.AddRectFilled({left, corner.y + middle}, {right, corner.y + height}, IM_COL32(grey, grey, grey, 255));
        if (ImGui::IsItemHovered() && static_cast<double>(at) >= u0 && static_cast<double>(at) < u1)
            ImGui::SetTooltip("u %.4f to %.4f: triangle %u, %s", u0, u1, triangle,
                              lit >= 0.0 ? fmt::format("lit {:.3f}", lit).c_str() : "away from the light");
    }
    widgets.dump().lastItem("seen.segments", values);
    ImGui::SameLine();
    ImGui::Text("%zu segment%s", segments.size(), segments.size() == 1 ? "" : "s");
}

}  // namespace

void drawProbe(Session& session, Widgets& widgets, const Area& picture) {
    const PixelProbe& probe = session.probe;
    if (!probe.on() || probe.square() == nullptr) return;
    const float unit = widgets.scale(), square = 8.0f * PixelProbe::side * unit;
    const ImVec2 end{picture.position.x + picture.size.x - 10.0f * unit,
                     picture.position.y + picture.size.y - 10.0f * unit};
    ImGui::SetNextWindowPos(end, ImGuiCond_Always, {1.0f, 1.0f});
    ImGui::SetNextWindowBgAlpha(0.94f);
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
    if (ImGui::Begin("probe", nullptr, flags)) {
        ImGui::BeginGroup();
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        ImGui::Image(imguiId(*probe.square()), {square, square});
        const float middle = 8.0f * unit * static_cast<float>(PixelProbe::side / 2);
        ImGui::GetWindowDrawList()->AddRect({corner.x + middle, corner.y + middle},
                                            {corner.x + middle + 8.0f * unit, corner.y + middle + 8.0f * unit},
                                            ImGui::GetColorU32(theme::accent));
        ImGui::TextColored(theme::quiet, "Pixel %d, %d, 8x", probe.x(), probe.y());
        ImGui::EndGroup();
        ImGui::SameLine();
        ImGui::BeginGroup();
        if (!probe.segments().empty()) {
            ImGui::TextColored(theme::quiet, "Seen at the pixel's centre, above how much of it is lit");
            drawSegments(probe.segments(), widgets);
        }
        ImGui::TextColored(theme::quiet, "Lit over the shutter, above ground truth");
        for (const PixelProbe::Row& row : probe.rows()) drawRow(row, widgets);
        if (!probe.caption().empty()) ImGui::TextColored(theme::warning, "%s", probe.caption().c_str());
        ImGui::EndGroup();
    }
    ImGui::End();
}

}  // namespace timeshade
