#include "panels/panels.h"
#include "panels/theme.h"

#include <algorithm>

#include <fmt/format.h>

#include "measure/view_scale.h"
#include "shared/heat_color.shared.h"

namespace timeshade {

namespace {

/// A heat map's colours from left to right, with the numbers that they stand for.
void drawScale(const TechniqueView& view, Widgets& widgets) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = 10.0f * widgets.scale();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    constexpr int pieces = 96;
    for (int i = 0; i < pieces; ++i) {
        const glm::vec3 color = shared::heatColor((static_cast<float>(i) + 0.5f) / pieces);
        const auto at = [&](int piece) { return corner.x + width * static_cast<float>(piece) / pieces; };
        list.AddRectFilled({at(i), corner.y}, {at(i + 1), corner.y + height},
                           ImGui::GetColorU32(ImVec4(color.x, color.y, color.z, 1.0f)));
    }
    const std::vector<ScaleMark> marks = marksOf(view);
    const auto leftOf = [&](const ScaleMark& mark) {
        const float size = ImGui::CalcTextSize(mark.text.c_str()).x;
        return std::clamp(width * static_cast<float>(mark.share) - 0.5f * size, 0.0f, std::max(0.0f, width - size));
    };
    const float gap = 8.0f * widgets.scale(), lastLeft = leftOf(marks.back());
    float free = 0.0f;
    for (const ScaleMark& mark : marks) {
        const float left = leftOf(mark), end = left + ImGui::CalcTextSize(mark.text.c_str()).x;
        const bool last = &mark == &marks.back();
        if (!last && (left < free || end + gap > lastLeft)) continue;
        list.AddText({corner.x + left, corner.y + height + 2.0f * widgets.scale()}, ImGui::GetColorU32(ImGuiCol_Text),
                     mark.text.c_str());
        free = end + gap;
    }
    ImGui::Dummy(
        {width, height + 2.0f * widgets.scale() + ImGui::GetTextLineHeight() + ImGui::GetStyle().ItemSpacing.y});
    widgets.dump().lastItem("view.scale", view.name);
}

/// What the technique itself has to show.
void drawTechniqueViews(Session& session, Widgets& widgets) {
    const std::vector<TechniqueView> views = session.technique.current().views();
    if (views.empty()) return;
    std::vector<std::string> names;
    std::size_t current = views.size();
    for (const TechniqueView& view : views) {
        if (view.name == session.view.ofTechnique && session.view.diagnostic == Diagnostic::None)
            current = names.size();
        names.push_back(view.name);
    }
    if (const auto chosen = widgets.choice("view.own", names, current)) session.view.show(names[*chosen]);
    if (current == views.size()) return;
    widgets.paragraph(views[current].title, theme::quiet);
    drawScale(views[current], widgets);
}

}  // namespace

void drawViewPanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.view", "View", true)) return;
    const auto diagnostic = static_cast<std::size_t>(session.view.diagnostic);
    constexpr std::size_t none = 2;
    const bool ofLight = diagnostic == 0 && session.view.ofTechnique.empty();
    if (const auto chosen =
            widgets.choice("view", {"Final", "Shadow visibility"},
                           ofLight ? static_cast<std::size_t>(session.view.light) : none, {"final", "visibility"}))
        session.view.show(*chosen == 0 ? "final" : "visibility");
    if (const auto chosen = widgets.choice("view", {"Image error", "Wrong shadow samples"},
                                           diagnostic == 0 ? none : diagnostic - 1, {"error", "disagreement"})) {
        session.view.show("final");
        session.view.diagnostic = static_cast<Diagnostic>(*chosen + 1);
    }
    drawTechniqueViews(session, widgets);
    const DiagnosticPicture& compared = session.diagnosticPicture;
    if (session.view.diagnostic != Diagnostic::None)
        widgets.paragraph(compared.caption(), compared.failed()     ? theme::bad
                                              : compared.complete() ? theme::quiet
                                                                    : theme::warning);
    if (session.view.light == View::Visibility && session.view.ofTechnique.empty())
        widgets.paragraph("The lit share of each pixel's camera samples: white lit, black shadowed.", theme::quiet);
    const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    if (widgets.button("screenshot", "Save PNG (P)", half)) session.requests.screenshot = true;
    ImGui::SameLine();
    if (widgets.button("screenshot.exr", "Save EXR (Shift-P)", half))
        session.requests.screenshot = session.requests.exr = true;
    if (!session.screenshots.lastPath().empty()) {
        widgets.paragraph(session.screenshots.lastPath(), theme::quiet);
        widgets.dump().lastItem("screenshot.path", session.screenshots.lastPath());
    }
    const auto preview = widgets.combo(
        "preview", "While it moves", {"Full", "Automatic", "Coarse"}, static_cast<std::size_t>(session.panels.preview),
        "How much is drawn while something moves. Full: all of it, however long that takes. Automatic: fewer pixels, "
        "then fewer samples where a frame would take more than 100 ms; the shadow map stays as long as it can. Coarse: "
        "a quarter of the sides at most.",
        {"full", "automatic", "coarse"});
    if (preview) session.panels.preview = static_cast<PreviewQuality::Choice>(*preview);
    static constexpr double steps[] = {0.75, 1.0, 1.25, 1.5, 2.0, 2.5};
    std::vector<std::string> names;
    std::size_t current = 1;
    for (const double step : steps) {
        if (step == session.panels.textScale) current = names.size();
        names.push_back(fmt::format("{:.0f} %", 100.0 * step));
    }
    if (const auto chosen = widgets.combo("text.size", "Text size", names, current,
                                          "Of all panels, on top of what the display asks for."))
        session.panels.textScale = steps[*chosen];
}

}  // namespace timeshade
