#include "window/state_dump.h"

#include <string>
#include <vector>

#include "window/session.h"
#include "window/ui_dump.h"

namespace timeshade {

namespace {

void dumpScene(const Session& session, UiDump& dump) {
    const Scene& scene = session.scene.current();
    dump.state("scene", session.scene.name());
    dump.state("clip", scene.clips().empty() ? "" : scene.clips()[scene.clip()]);
    dump.state("loading", session.loading.on() ? session.loading.text() : "");
    dump.state("technique", session.technique.name());
    dump.state("frame", session.moment.playback.frame());
    dump.state("playing", session.moment.playback.playing());
    dump.state("instant", session.moment.instant.value_or(-1.0));
    dump.state("hand_camera", session.camera.orbit.has_value());
}

/// What the picture that is shown was drawn with.
struct Drawn {
    int number = 0;
    nlohmann::json manifest;
};

void note(Drawn& drawn, const ShownPicture& shown) {
    if (shown.number == 0 || shown.number == drawn.number) return;
    const FrameRequest& request = shown.drawn;
    drawn = {shown.number,
             {{"technique", shown.technique},
              {"size", {request.width, request.height}},
              {"spp", request.samplesPerPixel},
              {"map", request.mapSize.text()}}};
}

void dumpPicture(const Session& session, UiDump& dump) {
    static constexpr const char* names[] = {"none", "drawing", "complete", "cancelled", "failed"};
    const FrameDriver& driver = session.driver;
    dump.state("picture", names[static_cast<int>(driver.state())]);
    dump.state("preview", driver.preview());
    dump.state("begun", driver.begun());
    if (driver.hasPlan()) {
        dump.state("renders", {session.renderer.rendersDone(), session.renderer.renders()});
    }
    if (driver.state() == FrameDriver::State::Failed) dump.state("failure", driver.failure());
    if (driver.shown().number > 0) dump.state("drawn", {driver.shown().drawn.width, driver.shown().drawn.height});
    static Drawn drawn;
    note(drawn, driver.shown());
    dump.state("manifest", drawn.manifest);
    dump.state("shown_preview", driver.shown().preview);
    dump.state("undo", {session.undo.undoable(), session.undo.redoable()});
    dump.state("shader_log", session.shaders.log);
    dump.state("shaders", session.shaders.number);
}

void dumpViews(Session& session, UiDump& dump) {
    static constexpr const char* diagnostics[] = {"none", "error", "disagreement"};
    const Comparison& comparison = session.comparison;
    dump.state("view", session.view.name());
    dump.state("diagnostic", {diagnostics[static_cast<int>(session.view.diagnostic)],
                              session.driver.settled() && session.diagnosticPicture.complete()});
    dump.state("compare", comparison.on() ? comparison.variants(session) : std::vector<std::string>{});
    dump.state("seam", comparison.seam);
    dump.state("probe", {session.probe.on(), session.probe.complete()});
}

void dumpSaved(const Session& session, UiDump& dump) {
    dump.state("screenshot", session.screenshots.lastPath());
    dump.state("saved", session.screenshots.count());
    dump.state("recording", {session.recording.on(), session.recording.frames()});
    dump.state("recorded", session.recording.lastPath());
    dump.state("command", session.panels.lastCommand);
    dump.state("panels", session.panels.visible);
}

}  // namespace

void dumpState(Session& session, UiDump& dump) {
    dumpScene(session, dump);
    dumpPicture(session, dump);
    dumpViews(session, dump);
    dumpSaved(session, dump);
}

}  // namespace timeshade
