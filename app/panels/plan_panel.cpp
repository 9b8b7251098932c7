#include <sstream>

#include "panels/panels.h"
#include "panels/theme.h"
#include "report.h"

namespace timeshade {

/// explain() as it is printed: a word of up to nine letters, and what there is to say about it.
void drawPlanPanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.plan", "Plan: what runs, and why", false)) return;
    if (!session.driver.hasPlan()) {
        widgets.paragraph("no data", theme::quiet);
        return;
    }
    constexpr std::size_t wordWidth = 10;
    std::istringstream lines(explain(session.renderer.plan(), *session.technique, session.renderer.device()));
    for (std::string line; std::getline(lines, line);) {
        const bool bad = line.starts_with("beware") || line.starts_with("CANNOT");
        if (line.starts_with("device") || line.size() <= wordWidth) continue;
        const std::size_t end = line.find_last_not_of(' ', wordWidth - 1);
        widgets.paragraph(line.substr(0, end + 1), bad ? theme::warning : theme::accent);
        ImGui::Indent();
        widgets.paragraph(line.substr(wordWidth), bad ? theme::warning : theme::text);
        ImGui::Unindent();
    }
}

} // namespace timeshade
