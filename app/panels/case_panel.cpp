#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "panels/panels.h"
#include "panels/theme.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

constexpr ImU32 atOpen = IM_COL32(110, 120, 135, 255), atClose = IM_COL32(120, 190, 255, 255),
                ofLight = IM_COL32(255, 214, 120, 255), ofReceiver = IM_COL32(130, 220, 140, 255),
                ofRays = IM_COL32(255, 214, 120, 90);

/// The case seen from the side, x to the right and z upwards: the world's place as the diagram's.
struct SideView {
    ImVec2 corner, size;
    glm::dvec2 low, high;

    ImVec2 operator()(const glm::dvec3& point) const {
        const double scale = std::min(static_cast<double>(size.x) / std::max(high.x - low.x, 1e-6),
                                      static_cast<double>(size.y) / std::max(high.y - low.y, 1e-6));
        const glm::dvec2 middle = 0.5 * (low + high);
        return {corner.x + 0.5f * size.x + static_cast<float>(scale * (point.x - middle.x)),
                corner.y + 0.5f * size.y - static_cast<float>(scale * (point.z - middle.y))};
    }
};

SideView sideViewOf(const ClosedFormCase& c, ImVec2 corner, ImVec2 size, bool spot) {
    glm::dvec2 low(1e9), high(-1e9);
    const auto take = [&](const glm::dvec3& point) {
        low = glm::min(low, glm::dvec2(point.x, point.z));
        high = glm::max(high, glm::dvec2(point.x, point.z));
    };
    take(c.receiverOpen);
    take(c.receiverClose);
    if (spot) {
        take(c.scene->lightOpen.position);
        take(c.scene->lightClose.position);
    }
    // Casters; the receiver's own plane may be as wide as it likes.
    for (std::size_t i = 0; i < c.scene->quads.size(); ++i)
        if (2 * i < c.firstReceiver)
            for (int k = 0; k < 4; ++k) {
                take(c.scene->quads[i].open[k]);
                take(c.scene->quads[i].close[k]);
            }
    const glm::dvec2 margin = 0.06 * (high - low) + 0.2;
    return {corner, size, low - margin, high + margin};
}

void drawOutline(ImDrawList& list, const SideView& at, const glm::dvec3* corners, int count, ImU32 color, float width) {
    for (int i = 0; i < count; ++i) list.AddLine(at(corners[i]), at(corners[(i + 1) % count]), color, width);
}

/// Light, casters and receiver at both ends of the shutter.
void drawDiagram(const ClosedFormCase& c, Widgets& widgets) {
    const float unit = widgets.scale();
    const ImVec2 corner = ImGui::GetCursorScreenPos(), size{ImGui::GetContentRegionAvail().x, 150.0f * unit};
    const ImVec2 end{corner.x + size.x, corner.y + size.y};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, end, ImGui::GetColorU32(ImGuiCol_FrameBg), 3.0f * unit);
    list.PushClipRect(corner, end, true);
    const bool spot = c.scene->lightOpen.kind == LightKind::Spot;
    const SideView at = sideViewOf(c, corner, size, spot);
    for (const bool close : {false, true}) {
        const LightPose& light = close ? c.scene->lightClose : c.scene->lightOpen;
        const glm::dvec3& receiver = close ? c.receiverClose : c.receiverOpen;
        const glm::dvec3 source = spot ? light.position : receiver + 1e3 * light.axes[2];
        list.AddLine(at(source), at(receiver), ofRays, unit);
        for (std::size_t i = 0; i < c.scene->quads.size(); ++i) {
            const MovingQuad& quad = c.scene->quads[i];
            const bool receives = 2 * i >= c.firstReceiver && i * 2 < c.firstReceiver + 2;
            drawOutline(list, at, close ? quad.close : quad.open, 4,
                        receives ? ofReceiver
                        : close  ? atClose
                                 : atOpen,
                        (close ? 2.0f : 1.5f) * unit);
        }
        for (const MovingCorners& triangle : c.scene->triangles)
            drawOutline(list, at, close ? triangle.close : triangle.open, 3, close ? atClose : atOpen, unit);
        list.AddCircleFilled(at(receiver), 3.5f * unit, ofReceiver);
        if (spot) list.AddCircleFilled(at(light.position), (close ? 4.5f : 3.0f) * unit, ofLight);
    }
    list.PopClipRect();
    ImGui::Dummy(size);
    widgets.dump().lastItem("case.diagram", c.name);
    widgets.paragraph(
        "From the side. Yellow: light; grey to blue: caster as the shutter opens and closes; green: "
        "receiver.",
        theme::quiet);
}

ImVec4 colorOf(Verdict verdict) {
    return verdict == Verdict::Right       ? theme::text
           : verdict == Verdict::Predicted ? theme::warning
           : verdict == Verdict::Wrong     ? theme::bad
                                           : theme::quiet;
}

std::string inWords(const CaseResult& result) {
    if (result.verdict == Verdict::NotTaken) return "not taken";
    const char* word = result.verdict == Verdict::Right       ? "right"
                       : result.verdict == Verdict::Predicted ? "off as predicted"
                                                              : "wrong";
    return fmt::format("{:.4f}  {}", result.value, word);
}

}  // namespace

void drawCasePanel(Session& session, Widgets& widgets) {
    const ClosedFormCase* shown = CaseStudy::caseOf(session.scene.name());
    if (shown == nullptr || !widgets.section("section.case", "Analytic case", true)) return;
    session.caseStudy.keepOn();
    widgets.paragraph(fmt::format("{}. Averaged over the shutter the receiver is lit for {:.4g} of it: that is known "
                                  "exactly. Hard for: {}.",
                                  shown->motion, shown->exact, shown->breaks),
                      theme::text);
    drawDiagram(*shown, widgets);
    widgets.figure("case.exact", "Exact share", fmt::format("{:.4f}", shown->exact));
    const std::vector<CaseResult>& results = session.caseStudy.results();
    for (const CaseResult& result : results) {
        ImGui::PushStyleColor(ImGuiCol_Text, colorOf(result.verdict));
        widgets.figure("case." + result.technique, techniqueDescription(result.technique).shortTitle, inWords(result));
        ImGui::PopStyleColor();
        if (ImGui::IsItemHovered() && result.verdict == Verdict::NotTaken)
            ImGui::SetTooltip("%s", result.reason.c_str());
    }
    if (results.size() < techniqueDescriptions().size()) widgets.paragraph("Measuring ...", theme::warning);
    widgets.dump().state("case", {{"name", shown->name}, {"measured", results.size()}});
}

}  // namespace timeshade
