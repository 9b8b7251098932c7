#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "panels/panels.h"
#include "panels/theme.h"
#include "report.h"

namespace timeshade {

namespace {

std::string milliseconds(double value) {
    return value < 10.0 ? fmt::format("{:.2f} ms", value) : fmt::format("{:.1f} ms", value);
}

/// A figure with a bar behind it that shows its share of the total.
void drawTime(Widgets& widgets, const std::string& id, const std::string& name, double value, double total) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float left = 130.0f * widgets.scale(), right = 80.0f * widgets.scale();
    const float room = std::max(0.0f, ImGui::GetContentRegionAvail().x - left - right);
    const float length = total > 0.0 ? room * static_cast<float>(std::clamp(value / total, 0.0, 1.0)) : 0.0f;
    const float inset = 4.0f * widgets.scale();
    ImGui::GetWindowDrawList()->AddRectFilled(
        {corner.x + left, corner.y + inset},
        {corner.x + left + length, corner.y + ImGui::GetTextLineHeight() - inset + 1.0f},
        ImGui::GetColorU32(ImVec4(0.30f, 0.45f, 0.60f, 1.0f)), 2.0f * widgets.scale());
    widgets.figure(id, name, milliseconds(value));
}

/// A step of the frame as a person would call it.
std::string titleOfStep(const std::string& step) {
    static const std::map<std::string, std::string> titles{{"sample", "Camera samples"},
                                                           {"build", "Shadow structure"},
                                                           {"lookup", "Shadow test"},
                                                           {"shade", "Shading"},
                                                           {"view", "View"}};
    const auto found = titles.find(step);
    return found == titles.end() ? step : found->second;
}

/// Each whole with its parts right behind it, whatever the order in which they were first met.
std::vector<gl::PassTimer::Reading> inOrder(const std::vector<gl::PassTimer::Reading>& readings) {
    std::vector<gl::PassTimer::Reading> ordered;
    for (const auto& whole : readings) {
        if (whole.isPart()) continue;
        ordered.push_back(whole);
        for (const auto& part : readings)
            if (part.isPart() && part.name.starts_with(whole.name + "/")) ordered.push_back(part);
    }
    return ordered;
}

void drawTimes(Session& session, Widgets& widgets) {
    const FrameTimes& times = session.driver.times();
    if (times.frames() == 0 || session.driver.shown().number == 0 || !session.driver.hasPlan()) {
        widgets.paragraph("No data yet", theme::quiet);
        widgets.dump().lastItem("times.none", true);
        return;
    }
    const double total = times.medianTotal();
    for (const auto& reading : inOrder(times.medians())) {
        // "build/collect" stands below "build", as its part.
        const std::string name =
            reading.isPart() ? "   " + reading.name.substr(reading.name.rfind('/') + 1) : titleOfStep(reading.name);
        drawTime(widgets, "times." + reading.name, name, reading.milliseconds, total);
    }
    widgets.figure("times.total", "Total", milliseconds(total));
    const ShownPicture& shown = session.driver.shown();
    std::string over = times.frames() == 1 ? "one frame" : fmt::format("median of {} frames", times.frames());
    if (session.renderer.renders() > 1) over += fmt::format(" of {} renders", session.renderer.renders());
    widgets.paragraph(
        fmt::format("{}{}, {} × {}, {} spp, map {}", shown.preview ? "Preview, " : "", over, shown.drawn.width,
                    shown.drawn.height, shown.drawn.samplesPerPixel, shown.drawn.mapSize.text()),
        theme::quiet);
    if (session.renderer.renders() > 1 || session.driver.preview()) return;
    // A paused picture is drawn once, and the first time compiles programs.
    if (session.driver.measuring())
        widgets.paragraph("Measuring ...", theme::warning);
    else if (widgets.button("times.measure", "Measure again"))
        session.driver.measure(static_cast<int>(FrameTimes::kept));
}

void drawMemory(Session& session, Widgets& widgets) {
    if (!session.driver.hasPlan()) {
        widgets.paragraph("No data yet", theme::quiet);
        return;
    }
    const GpuMemory memory = session.renderer.memory();
    widgets.figure("memory.mesh", "Mesh", inMebibytes(memory.mesh));
    widgets.figure("memory.samples", "Camera samples", inMebibytes(memory.samples));
    widgets.figure("memory.visibility", "Visibility", inMebibytes(memory.visibility));
    widgets.figure("memory.technique", "Technique", inMebibytes(memory.technique));
    widgets.figure("memory.picture", "Picture", inMebibytes(memory.picture));
    widgets.figure("memory.total", "Total", inMebibytes(memory.total()));
    if (session.comparison.on()) widgets.figure("memory.second", "Side B", inMebibytes(session.comparison.bytes()));
    widgets.figure("memory.undo", fmt::format("Undo, {} steps", session.undo.undoable() + session.undo.redoable()),
                   inMebibytes(session.undo.bytes()));
}

/// A bar a picture, the newest at the right; previews are paler.
void drawFrameGraph(Session& session, Widgets& widgets) {
    const std::vector<FrameGraph::Bar>& bars = session.graph.bars();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = 60.0f * widgets.scale();
    float most = 1.0f;
    for (const FrameGraph::Bar& bar : bars) most = std::max(most, bar.milliseconds);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, {corner.x + width, corner.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg),
                       3.0f * widgets.scale());
    const float step = width / static_cast<float>(FrameGraph::kept);
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const float right = corner.x + width - step * static_cast<float>(bars.size() - 1 - i);
        const float top = corner.y + height * (1.0f - bars[i].milliseconds / most);
        const ImVec4 color = bars[i].preview ? ImVec4(0.45f, 0.40f, 0.25f, 1.0f) : ImVec4(0.30f, 0.50f, 0.70f, 1.0f);
        list.AddRectFilled({right - std::max(step - 1.0f, 1.0f), top}, {right, corner.y + height},
                           ImGui::GetColorU32(color));
    }
    ImGui::Dummy({width, height});
    widgets.dump().lastItem("times.graph", bars.size());
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("The last %zu pictures; the highest took %s. Previews are brown.", bars.size(),
                          milliseconds(static_cast<double>(most)).c_str());
}

}  // namespace

void drawTimesPanel(Session& session, Widgets& widgets) {
    if (widgets.section("section.times", "Time", true)) {
        drawFrameGraph(session, widgets);
        drawTimes(session, widgets);
    }
    if (widgets.section("section.memory", "Memory", false)) drawMemory(session, widgets);
}

}  // namespace timeshade
