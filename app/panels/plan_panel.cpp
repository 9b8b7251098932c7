#include <fmt/format.h>

#include "panels/panels.h"
#include "panels/theme.h"
#include "report.h"

namespace timeshade {

/// What --explain prints, with the time that each pass took in the last frame.
void drawPlanPanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.plan", "Frame plan", false)) return;
    if (!session.driver.hasPlan()) {
        widgets.paragraph("No data", theme::quiet);
        return;
    }
    const std::vector<gl::PassTimer::Reading> times = session.driver.times().medians();
    for (const PlanLine& line :
         explainedLines(session.renderer.plan(), session.technique.current(), session.renderer.device())) {
        if (line.word == "device") continue;
        const bool bad = line.word == "warning" || line.word == "unsupported";
        std::string word = line.word;
        for (const gl::PassTimer::Reading& reading : times)
            if (reading.name == line.word) word += fmt::format("  {:.1f} ms", reading.milliseconds);
        widgets.paragraph(word, bad ? theme::warning : theme::accent);
        ImGui::Indent();
        widgets.paragraph(line.text, bad ? theme::warning : theme::text);
        ImGui::Unindent();
    }
}

}  // namespace timeshade
