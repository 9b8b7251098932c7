#include "window/chips.h"

#include <fmt/format.h>

#include "window/session.h"

namespace timeshade {

namespace {

std::optional<Chip> truthChip(const Comparison& comparison) {
    const TruthRefinement& truth = comparison.truth();
    if (comparison.kind() != ComparedSide::Kind::Truth || truth.samples() == 0 || truth.complete()) return std::nullopt;
    if (truth.stopped())
        return Chip{"truth", fmt::format("ground truth stopped at {} spp", truth.samples()), "Goes on tracing rays"};
    return Chip{"truth", fmt::format("ground truth {} of {} spp", truth.samples(), truthSamples), "Stops tracing rays"};
}

}  // namespace

std::vector<Chip> chipsOf(const Session& session) {
    using State = FrameDriver::State;
    const FrameDriver& driver = session.driver;
    const ShownPicture& shown = driver.shown();
    std::vector<Chip> chips;
    if (session.recording.on())
        chips.push_back({"recording", fmt::format("recording {} frames", session.recording.frames()),
                         "Stops recording and closes the file"});
    if (const std::optional<double> done = session.progress())
        chips.push_back({"rendering", fmt::format("rendering {:.0f} %", 100.0 * *done), "Stops rendering"});
    else if (driver.state() == State::Cancelled)
        chips.push_back({"stopped", "stopped", "Goes on rendering"});
    if (const std::optional<Chip> truth = truthChip(session.comparison)) chips.push_back(*truth);
    if (shown.preview)
        chips.push_back({"preview", fmt::format("preview {} x {}", shown.drawn.width, shown.drawn.height),
                         "Draws the full picture now"});
    if (session.moment.instant)
        chips.push_back({"instant", fmt::format("one instant u = {:.3g}", *session.moment.instant),
                         "Shows the whole shutter again"});
    if (shown.number > 0 && shown.cached)
        chips.push_back({"cached", "cached", "Draws the picture without anything of earlier frames"});
    return chips;
}

void leaveState(Session& session, const std::string& id) {
    if (id == "recording") session.requests.recording = true;
    if (id == "rendering") {
        session.driver.cancel();
        session.comparison.cancel();
    }
    if (id == "stopped") {
        session.driver.resume();
        session.comparison.resume();
    }
    if (id == "truth") {
        TruthRefinement& truth = session.comparison.truth();
        truth.stopped() ? truth.resume() : truth.stop();
    }
    if (id == "preview") session.requests.full = true;
    if (id == "instant") session.moment.instant.reset();
    if (id == "cached") session.requests.uncached = true;
}

namespace {

/// What lies over the picture.
bool closeBox(Session& session) {
    PanelState& panels = session.panels;
    if (session.loading.on()) {
        session.loading.cancel();
        session.notify("Loading was stopped");
    } else if (panels.keysVisible) {
        panels.keysVisible = false;
    } else if (panels.pageVisible) {
        panels.pageVisible = false;
    } else if (session.probe.on()) {
        session.probe.clear();
    } else if (session.notices.current()) {
        session.notices.close();
    } else if (panels.storyVisible) {
        panels.storyVisible = false;
    } else {
        return false;
    }
    return true;
}

}  // namespace

bool closeTopmost(Session& session) {
    if (closeBox(session)) return true;
    if (session.view.diagnostic != Diagnostic::None) {
        session.view.diagnostic = Diagnostic::None;
    } else if (session.progress()) {
        leaveState(session, "rendering");
    } else if (session.moment.instant) {
        session.moment.instant.reset();
    } else {
        return false;
    }
    return true;
}

}  // namespace timeshade
