#include <algorithm>
#include <bit>
#include <filesystem>

#include <fmt/format.h>

#include "panels/panels.h"
#include "panels/theme.h"
#include "report.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

/// Techniques, the ground truth, and the file that is compared with, if any.
void drawPartnerList(Session& session, Widgets& widgets) {
    const Comparison& comparison = session.comparison;
    std::vector<std::string> titles{"None", "Ground truth"}, names{"", truthName}, ids{"none", truthName};
    std::size_t current = comparison.on() && comparison.kind() == ComparedSide::Kind::Truth ? 1 : 0;
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        if (comparison.technique() != nullptr && comparison.technique()->description().name == description.name)
            current = names.size();
        titles.push_back(description.shortTitle);
        names.push_back(description.name);
        ids.push_back(description.name);
    }
    if (comparison.on() && comparison.kind() == ComparedSide::Kind::File) {
        current = names.size();
        names.push_back(comparison.wholeVariant());
        titles.push_back(std::filesystem::path(names.back()).filename().string());
        ids.emplace_back("file");
    }
    const auto chosen =
        widgets.combo("compare", "With", titles, current,
                      "Side B: a second technique, drawn of the same frame with the same camera samples; or the ground "
                      "truth, ray traced with more and more samples while nothing changes, and kept on disk.",
                      ids);
    if (chosen && *chosen != current) session.requests.comparison = names[*chosen];
}

void drawFileField(Session& session, Widgets& widgets) {
    const float width = 52.0f * widgets.scale();
    const bool entered = widgets.field("compare.path", "path of a .png or .exr file", session.panels.comparePath,
                                       width + ImGui::GetStyle().ItemSpacing.x);
    ImGui::SameLine();
    const bool pressed = widgets.button("compare.load", "Load", width);
    if ((!entered && !pressed) || session.panels.comparePath.empty()) return;
    if (ComparedSide::of(session.panels.comparePath).kind == ComparedSide::Kind::File)
        session.requests.comparison = session.panels.comparePath;
    else
        session.notify(session.panels.comparePath + ": expected a name that ends in .png or .exr", true);
}

void drawModes(Comparison& comparison, Widgets& widgets) {
    const std::size_t mode = comparison.flip ? 3 : static_cast<std::size_t>(comparison.mode);
    if (const auto picked = widgets.choice("compare.mode", {"Wipe", "Side by side", "Difference", "A/B flip"}, mode,
                                           {"wipe", "side", "difference", "flip"})) {
        comparison.flip = *picked == 3;
        comparison.mode = comparison.flip ? CompareMode::Wipe : static_cast<CompareMode>(*picked);
    }
    if (comparison.flip || comparison.mode != CompareMode::Difference) return;
    // Powers of two by hand; any whole number from a file or a command line.
    std::vector<std::string> gains;
    std::size_t current = 0;
    for (int gain = 1; gain <= 64; gain *= 2) {
        if (gain <= comparison.gain) current = gains.size();
        gains.push_back(fmt::format("{} x", gain));
    }
    if (!std::has_single_bit(static_cast<unsigned>(comparison.gain)) || comparison.gain > 64) {
        current = gains.size();
        gains.push_back(fmt::format("{} x", comparison.gain));
    }
    const auto gain = widgets.combo("compare.gain", "Gain", gains, current,
                                    "How many times as bright the difference is drawn. The legend in the picture says "
                                    "which difference is white; the pixel under the mouse stands beside it.");
    if (gain && *gain < 7) comparison.gain = 1 << *gain;
}

/// The samples of side B, where they are not those of A.
void drawOwnSamples(Comparison& comparison, Widgets& widgets) {
    if (!comparison.ownSamples()) return;
    Widgets::Number number;
    number.minimum = 1.0;
    number.maximum = maximumSamplesPerPixel;
    number.format = "%d";
    number.help = "Camera samples per pixel of side B alone.";
    widgets.slider("compare.spp", "Samples of B", *comparison.ownSamples(), number);
    if (widgets.button("compare.spp.same", "Same samples as A", ImGui::GetContentRegionAvail().x))
        comparison.ownSamples().reset();
}

}  // namespace

void drawComparePanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.compare", "Compare", true)) return;
    Comparison& comparison = session.comparison;
    drawPartnerList(session, widgets);
    drawFileField(session, widgets);
    if (widgets.button("compare.pin", "Snapshot as B", ImGui::GetContentRegionAvail().x))
        session.requests.snapshot = true;
    if (!comparison.on()) return;
    drawModes(comparison, widgets);
    drawOwnSamples(comparison, widgets);
    if (comparison.technique() != nullptr &&
        widgets.button("compare.swap", "Swap A/B (X)", ImGui::GetContentRegionAvail().x))
        session.requests.swap = true;
    widgets.paragraph(comparison.flip                        ? "Hold F to see B."
                      : comparison.mode == CompareMode::Wipe ? "Drag the seam in the picture; hold F to see B alone."
                                                             : "Hold F to see B alone.",
                      theme::quiet);
    if (!comparison.complaint().empty()) {
        widgets.paragraph(comparison.complaint(), theme::bad);
        widgets.dump().lastItem("compare.complaint", comparison.complaint());
        if (widgets.button("compare.fit", "Make the picture as large", ImGui::GetContentRegionAvail().x))
            session.requests.fit = true;
    }
    widgets.figure("compare.memory", "Memory of side B", inMebibytes(comparison.bytes()));
}

}  // namespace timeshade
