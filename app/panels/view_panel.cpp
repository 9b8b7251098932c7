#include "panels/panels.h"
#include "panels/theme.h"

#include <fmt/format.h>

namespace timeshade {

void drawViewPanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.view", "View", true)) return;
    const auto diagnostic = static_cast<std::size_t>(session.diagnostic);
    constexpr std::size_t none = 2;
    if (const auto chosen = widgets.choice("view", {"final", "visibility"}, diagnostic == 0 ? static_cast<std::size_t>(session.view) : none)) {
        session.view = static_cast<View>(*chosen);
        session.diagnostic = Diagnostic::None;
    }
    if (const auto chosen = widgets.choice("view", {"error", "disagreement"}, diagnostic == 0 ? none : diagnostic - 1)) {
        session.view = View::Final;
        session.diagnostic = static_cast<Diagnostic>(*chosen + 1);
    }
    const DiagnosticPicture& compared = session.diagnosticPicture;
    if (session.diagnostic != Diagnostic::None)
        widgets.paragraph(compared.caption(), compared.failed() ? theme::bad : compared.complete() ? theme::quiet : theme::warning);
    if (session.view == View::Visibility) widgets.paragraph("The lit share of each pixel's camera samples: white lit, black shadowed.", theme::quiet);
    if (widgets.button("screenshot", "Save picture (P)")) session.wishedScreenshot = true;
    if (!session.lastScreenshot.empty()) {
        widgets.paragraph(session.lastScreenshot, theme::quiet);
        widgets.dump().lastItem("screenshot.path", session.lastScreenshot);
    }
    static constexpr double steps[] = {0.75, 1.0, 1.25, 1.5, 2.0, 2.5};
    std::vector<std::string> names;
    std::size_t current = 1;
    for (const double step : steps) {
        if (step == session.textScale) current = names.size();
        names.push_back(fmt::format("{:.0f} %", 100.0 * step));
    }
    if (const auto chosen = widgets.combo("text.size", "Text size", names, current, "Of all panels, on top of what the display asks for."))
        session.textScale = steps[*chosen];
}

} // namespace timeshade
