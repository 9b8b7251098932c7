#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "core/error.h"
#include "panels/imgui_versions.h"
#include "panels/panels.h"
#include "panels/theme.h"
#include "report.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

constexpr float chartHeight = 220.0f, smallestChartWidth = 260.0f;
constexpr double chartScale = 0.8;

std::string progressOf(const Accuracy& accuracy) {
    switch (accuracy.state()) {
    case Accuracy::State::Waiting: return "Waiting for a still picture";
    case Accuracy::State::Reference:
        return fmt::format("Computing the reference: {:.0f} %", 100.0 * accuracy.probe().referenceProgress());
    case Accuracy::State::Measuring:
        return accuracy.trying().empty() ? "Measuring ..." : fmt::format("Trying {} ...", accuracy.trying());
    case Accuracy::State::Failed: return "Cannot be measured: " + accuracy.failure();
    case Accuracy::State::Idle: break;
    }
    return "";
}

void drawChartOf(Session& session, Widgets& widgets) {
    const float width = std::max(ImGui::GetContentRegionAvail().x, smallestChartWidth * widgets.scale());
    const float height = chartHeight * widgets.scale();
    // As sharp as the display: in its pixels, not in ImGui's units.
    const float pixels = ImGui::GetIO().DisplayFramebufferScale.x;
    const auto inPixels = [&](float units) { return static_cast<int>(std::lround(units * pixels)); };
    const Accuracy& accuracy = session.accuracy;
    TrailChart& chart = session.trailChart;
    try {
        chart.update(accuracy.trail(), accuracy.current(), accuracy.revision(), inPixels(width), inPixels(height),
                     chartScale * static_cast<double>(widgets.scale() * pixels), session.renderer.device().software);
    } catch (const Error& error) {
        widgets.paragraph(error.what(), theme::bad);
        return;
    }
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Image(imguiId(*chart.picture()), {width, height});
    widgets.dump().lastItem("accuracy.chart", accuracy.trail().size());
    if (const auto place = chart.currentPlace()) {
        const ImVec2 centre{corner.x + static_cast<float>(place->x) / pixels,
                            corner.y + static_cast<float>(place->y) / pixels};
        ImGui::GetWindowDrawList()->AddCircle(centre, 8.0f * widgets.scale(), IM_COL32(20, 20, 24, 255), 0,
                                              1.6f * widgets.scale());
    }
}

/// The technique to be held against the current one; by default the next in the list.
std::string drawOther(Session& session, Widgets& widgets) {
    const std::vector<TechniqueDescription>& all = techniqueDescriptions();
    const std::string& now = session.technique.name();
    std::vector<std::string> names, titles;
    for (const TechniqueDescription& description : all) {
        if (description.name == now) continue;
        names.push_back(description.name);
        titles.push_back(description.shortTitle);
    }
    if (names.empty()) return "";
    auto chosen = std::find(names.begin(), names.end(), session.accuracyOther);
    if (chosen == names.end()) chosen = names.begin();
    const auto picked = widgets.combo(
        "accuracy.other", "Against", titles, static_cast<std::size_t>(chosen - names.begin()),
        "The technique that the two buttons put beside the current one, as B, with as many samples a pixel "
        "(or renders) as make it as slow, or as wrong.",
        names);
    session.accuracyOther = picked ? names[*picked] : *chosen;
    return session.accuracyOther;
}

void drawButtons(Session& session, Widgets& widgets, const std::string& other) {
    Accuracy& accuracy = session.accuracy;
    const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    const bool ready = accuracy.current() != nullptr && accuracy.state() == Accuracy::State::Idle && !other.empty();
    ImGui::BeginDisabled(!ready);
    if (widgets.button("accuracy.time", "Equal time", half)) accuracy.match(session, other, Accuracy::Level::Time);
    ImGui::SameLine();
    if (widgets.button("accuracy.error", "Equal error", half)) accuracy.match(session, other, Accuracy::Level::Error);
    ImGui::EndDisabled();
    if (!accuracy.trying().empty()) {
        if (widgets.button("accuracy.stop", "Stop", half)) accuracy.stopMatch();
    } else if (widgets.button("accuracy.clear", "Clear", half)) {
        accuracy.clear();
    }
}

}  // namespace

void drawAccuracyPanel(Session& session, Widgets& widgets) {
    static constexpr const char* states[] = {"waiting", "reference", "measuring", "idle", "failed"};
    if (!widgets.section("section.accuracy", "Accuracy", false)) return;
    Accuracy& accuracy = session.accuracy;
    accuracy.keepOn();
    // What is not of the settings as they are now is not shown beside them.
    const ProbePoint* measured = accuracy.current();
    const ProbePoint* current = measured != nullptr && measured->subject == subjectOf(session) ? measured : nullptr;
    if (current != nullptr)
        widgets.figure(
            "accuracy.of", "Of",
            fmt::format("{}, map {}", sampleCountInWords(current->subject), current->subject.mapSize.text()));
    const auto number = [&](double value) { return current != nullptr ? fmt::format("{:.4g}", value) : "-"; };
    widgets.figure("accuracy.shadow", "Shadow error (RMS)", number(current != nullptr ? current->shadowError : 0.0));
    if (current != nullptr && current->wrongPpm)
        widgets.figure("accuracy.ppm", "Wrong shadow samples",
                       inWords({"", std::round(*current->wrongPpm), "ppm", ""}));
    widgets.figure("accuracy.rmse", "Image RMSE", number(current != nullptr ? current->rmse : 0.0));
    widgets.figure("accuracy.ms", "Frame", current != nullptr ? fmt::format("{:.4g} ms", current->milliseconds) : "-");
    const std::string progress = progressOf(accuracy);
    const std::string how =
        fmt::format("At {} × {}, against {} rays per pixel (image: {} samples)", accuracy.probe().width(),
                    accuracy.probe().height(), AccuracyProbe::referenceRays, AccuracyProbe::referenceSamples);
    widgets.paragraph(progress.empty() ? how : progress, accuracy.state() == Accuracy::State::Failed ? theme::bad
                                                         : progress.empty()                          ? theme::quiet
                                                                                                     : theme::warning);
    widgets.dump().lastItem("accuracy.progress", progress);
    drawChartOf(session, widgets);
    drawButtons(session, widgets, drawOther(session, widgets));
    if (!accuracy.said().empty()) widgets.paragraph(accuracy.said(), theme::text);
    widgets.dump().state("accuracy", {{"state", states[static_cast<int>(accuracy.state())]},
                                      {"points", accuracy.trail().size()},
                                      {"said", accuracy.said()}});
}

}  // namespace timeshade
