#include "panels/widgets.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include <imgui_stdlib.h>

#include "panels/imgui_versions.h"
#include "panels/theme.h"

namespace timeshade {

namespace {

constexpr float labelWidth = 122.0f, marksWidth = 42.0f, leastControl = 64.0f;

/// The first entry of each row of buttons of these widths, and the end, where a row is as wide as `width`.
std::vector<std::size_t> rowsOf(const std::vector<float>& widths, float gap, float width) {
    std::vector<std::size_t> begins{0};
    float used = 0.0f;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        if (i > begins.back() && used + gap + widths[i] > width) begins.push_back(i);
        used = i == begins.back() ? widths[i] : used + gap + widths[i];
    }
    begins.push_back(widths.size());
    return begins;
}

void tooltip(const std::string& text) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0f);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void drawTriangle(ImVec2 centre, float radius, float direction, ImU32 color) {
    const float x = radius * direction;
    ImGui::GetWindowDrawList()->AddTriangleFilled({centre.x - 0.7f * x, centre.y - radius}, {centre.x + x, centre.y},
                                                  {centre.x - 0.7f * x, centre.y + radius}, color);
}

void drawBar(ImVec2 centre, float offset, float radius, ImU32 color) {
    const float half = 0.22f * radius;
    ImGui::GetWindowDrawList()->AddRectFilled({centre.x + offset - half, centre.y - radius},
                                              {centre.x + offset + half, centre.y + radius}, color);
}

void drawIcon(Icon icon, ImVec2 centre, float radius, ImU32 color) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float thickness = std::max(1.0f, 0.3f * radius);
    switch (icon) {
    case Icon::Play: drawTriangle(centre, radius, 1.0f, color); return;
    case Icon::Pause:
        drawBar(centre, -0.45f * radius, radius, color);
        drawBar(centre, 0.45f * radius, radius, color);
        return;
    case Icon::StepBack:
        drawTriangle({centre.x + 0.2f * radius, centre.y}, 0.85f * radius, -1.0f, color);
        drawBar(centre, -0.9f * radius, 0.85f * radius, color);
        return;
    case Icon::StepForward:
        drawTriangle({centre.x - 0.2f * radius, centre.y}, 0.85f * radius, 1.0f, color);
        drawBar(centre, 0.9f * radius, 0.85f * radius, color);
        return;
    case Icon::Reset:
        list.PathArcTo(centre, radius, -0.9f, 4.2f, 20);
        list.PathStroke(color, 0, thickness);
        list.AddTriangleFilled({centre.x + 0.05f * radius, centre.y - 1.05f * radius},
                               {centre.x + 1.05f * radius, centre.y - 1.35f * radius},
                               {centre.x + 1.05f * radius, centre.y - 0.2f * radius}, color);
        return;
    case Icon::Close:
        list.AddLine({centre.x - radius, centre.y - radius}, {centre.x + radius, centre.y + radius}, color, thickness);
        list.AddLine({centre.x - radius, centre.y + radius}, {centre.x + radius, centre.y - radius}, color, thickness);
        return;
    }
}

}  // namespace

std::string titleOfKey(const std::string& key) {
    std::string title;
    std::istringstream words(key);
    for (std::string word; std::getline(words, word, '_');) {
        const bool abbreviation = word.find_first_of("aeiouy") == std::string::npos;  // "pcf"
        for (std::size_t i = 0; i < word.size(); ++i)
            if (abbreviation || (i == 0 && title.empty()))
                word[i] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[i])));
        title += (title.empty() ? "" : " ") + word;
    }
    return title;
}

bool Widgets::section(const std::string& id, const char* title, bool open) {
    ImGui::Dummy({0.0f, 1.0f * scale_});
    const auto other = sections_.find(id);
    const bool atFirst = other == sections_.end() ? open : other->second;
    const bool unfolded =
        ImGui::CollapsingHeader(title, atFirst ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
    if (unfolded == open)
        sections_.erase(id);
    else
        sections_[id] = unfolded;
    dump_.lastItem(id, unfolded);
    return unfolded;
}

void Widgets::beginRow(const std::string& label, const std::string& helpText) {
    const float start = ImGui::GetCursorPosX();
    const float inner = ImGui::GetContentRegionAvail().x;
    // Where the panel is narrow, the label stands above.
    const bool beside = !label.empty() && inner >= (labelWidth + leastControl + marksWidth) * scale_;
    if (!label.empty()) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(label.c_str());
        if (!helpText.empty() && ImGui::IsItemHovered()) tooltip(helpText);
        if (beside) ImGui::SameLine(start + labelWidth * scale_);
    }
    const float used = beside ? labelWidth * scale_ : 0.0f;
    ImGui::SetNextItemWidth(std::max(20.0f * scale_, inner - used - marksWidth * scale_));
}

void Widgets::help(const std::string& text) {
    if (text.empty()) return;
    ImGui::SameLine(contentRight() - 36.0f * scale_);
    ImGui::TextColored(theme::quiet, "(?)");
    if (ImGui::IsItemHovered()) tooltip(text);
}

bool Widgets::reset(const std::string& id, bool differs) {
    if (!differs) return false;
    ImGui::SameLine();
    ImGui::SetCursorPosX(contentRight() - 15.0f * scale_);
    return iconButton(id + ".reset", Icon::Reset, "Reset to default", 15.0f * scale_);
}

bool Widgets::slider(const std::string& id, const std::string& label, double& value, const Number& number) {
    beginRow(label, number.help);
    const double before = value;
    ImGuiSliderFlags flags = number.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
    ImGui::SliderScalar(("##" + id).c_str(), ImGuiDataType_Double, &value, &number.minimum, &number.maximum,
                        number.format.c_str(), flags);
    value = std::isfinite(value)
                ? std::clamp(value, number.least.value_or(number.minimum), number.most.value_or(number.maximum))
                : before;
    dump_.lastItem(id, value);
    help(number.help);
    if (number.defaultValue &&
        reset(id, std::abs(value - *number.defaultValue) > 1e-6 * std::max(1.0, std::abs(value))))
        value = *number.defaultValue;
    return value != before;
}

bool Widgets::slider(const std::string& id, const std::string& label, int& value, const Number& number) {
    beginRow(label, number.help);
    const int before = value, low = static_cast<int>(number.minimum), high = static_cast<int>(number.maximum);
    const ImGuiSliderFlags flags = number.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
    ImGui::SliderInt(("##" + id).c_str(), &value, low, high, number.format.c_str(), flags);
    value = std::clamp(value, low, high);
    dump_.lastItem(id, value);
    help(number.help);
    if (number.defaultValue && reset(id, value != static_cast<int>(*number.defaultValue)))
        value = static_cast<int>(*number.defaultValue);
    return value != before;
}

bool Widgets::checkbox(const std::string& id, const std::string& label, bool& value, bool defaultValue,
                       const std::string& helpText) {
    beginRow(label, helpText);
    const bool before = value;
    ImGui::Checkbox(("##" + id).c_str(), &value);
    dump_.lastItem(id, value);
    help(helpText);
    if (reset(id, value != defaultValue)) value = defaultValue;
    return value != before;
}

std::optional<std::size_t> Widgets::combo(const std::string& id, const std::string& label,
                                          const std::vector<std::string>& entries, std::size_t current,
                                          const std::string& helpText, const std::vector<std::string>& ids) {
    std::optional<std::size_t> chosen;
    beginRow(label, helpText);
    if (label.empty() && helpText.empty()) ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    const std::string shown = current < entries.size() ? entries[current] : "";
    if (!ImGui::BeginCombo(("##" + id).c_str(), shown.c_str(), ImGuiComboFlags_HeightLarge)) {
        dump_.lastItem(id, shown);
    } else {
        for (std::size_t i = 0; i < entries.size(); ++i) {
            ImGui::PushID(static_cast<int>(i));
            if (ImGui::Selectable(entries[i].c_str(), i == current)) chosen = i;
            dump_.lastItem(id + "/" + (ids.empty() ? entries : ids)[i], i == current);
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    help(helpText);
    return chosen;
}

std::optional<std::size_t> Widgets::choice(const std::string& id, const std::vector<std::string>& entries,
                                           std::size_t current, const std::vector<std::string>& ids) {
    std::optional<std::size_t> chosen;
    const float gap = 2.0f * scale_, whole = ImGui::GetContentRegionAvail().x;
    std::vector<float> widths;
    for (const std::string& text : entries)
        widths.push_back(ImGui::CalcTextSize(text.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x);
    const std::vector<std::size_t> begins = rowsOf(widths, gap, whole);
    for (std::size_t row = 0; row + 1 < begins.size(); ++row) {
        // Longer words get wider buttons: what is left of the row is shared evenly.
        const auto count = static_cast<float>(begins[row + 1] - begins[row]);
        float left = whole - gap * (count - 1.0f);
        for (std::size_t i = begins[row]; i < begins[row + 1]; ++i) left -= widths[i];
        for (std::size_t i = begins[row]; i < begins[row + 1]; ++i) {
            if (i > begins[row]) ImGui::SameLine(0.0f, gap);
            const bool down = i == current;
            if (down) ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.23f, 0.38f, 0.53f, 1.0f));
            if (ImGui::Button((entries[i] + "##" + id).c_str(), {std::max(widths[i] + left / count, 1.0f), 0.0f}))
                chosen = i;
            if (down) ImGui::PopStyleColor();
            dump_.lastItem(id + "/" + (ids.empty() ? entries : ids)[i], down);
        }
    }
    return chosen;
}

std::optional<std::size_t> Widgets::tabs(const std::string& id, const std::vector<std::string>& titles,
                                         std::size_t current, const std::vector<std::string>& ids) {
    const auto chosen = choice(id, titles, current, ids);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine(
        {corner.x, corner.y - 0.5f * ImGui::GetStyle().ItemSpacing.y},
        {corner.x + ImGui::GetContentRegionAvail().x, corner.y - 0.5f * ImGui::GetStyle().ItemSpacing.y},
        ImGui::GetColorU32(ImGuiCol_Border));
    return chosen;
}

bool Widgets::button(const std::string& id, const std::string& text, float width) {
    const bool pressed = ImGui::Button((text + "##" + id).c_str(), {width, 0.0f});
    dump_.lastItem(id, text);
    return pressed;
}

bool Widgets::iconButton(const std::string& id, Icon icon, const char* tip, float side) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float height = std::max(side, ImGui::GetFrameHeight());
    const bool pressed = ImGui::InvisibleButton(id.c_str(), {side, height});
    const bool hovered = ImGui::IsItemHovered();
    dump_.lastItem(id, tip);
    drawIcon(icon, {corner.x + 0.5f * side, corner.y + 0.5f * height}, 0.28f * side,
             ImGui::GetColorU32(hovered ? theme::accent : theme::text));
    if (hovered) tooltip(tip);
    return pressed;
}

bool Widgets::field(const std::string& id, const char* hint, std::string& text, float reserved) {
    ImGui::SetNextItemWidth(std::max(20.0f * scale_, ImGui::GetContentRegionAvail().x - reserved));
    const bool entered =
        ImGui::InputTextWithHint(("##" + id).c_str(), hint, &text, ImGuiInputTextFlags_EnterReturnsTrue);
    dump_.lastItem(id, text);
    return entered;
}

void Widgets::paragraph(const std::string& text, const ImVec4& color) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void Widgets::figure(const std::string& id, const std::string& label, const std::string& value) {
    ImGui::TextColored(theme::quiet, "%s", label.c_str());
    ImGui::SameLine();
    const float right = contentRight() - ImGui::CalcTextSize(value.c_str()).x;
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), right));
    ImGui::TextUnformatted(value.c_str());
    dump_.lastItem(id, value);
}

}  // namespace timeshade
