#include "interactive.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#define GLFW_INCLUDE_NONE  // glad declares OpenGL
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include "contexts/window_context.h"
#include "core/error.h"
#include "frame_setup.h"
#include "gl/debug_log.h"
#include "gl/waits.h"
#include "image/image_file.h"
#include "panels/panels.h"
#include "report.h"
#include "scene_catalogue.h"
#include "window/controls.h"
#include "window/drawing_state.h"
#include "window/frame_log.h"
#include "window/picture_view.h"
#include "window/session.h"
#include "window/settings_io.h"
#include "window/slices.h"
#include "window/state_dump.h"
#include "window/ui_dump.h"
#include "window/ui_window.h"
#include "window/window_memory.h"

namespace timeshade {

namespace {

/// ImGui needs a few frames to show what an event has changed.
constexpr int framesAfterActivity = 3;
// Of the window, while a picture is being drawn: so long at most from the end of one to that of the next, if a slice of
// the work ends when it should.
constexpr double secondsBetweenFrames = 0.095, secondsOfSlice = 0.035;
constexpr double longestSleep = 0.25;  // seconds; notices end by themselves

WindowOptions windowOptions(const ViewOptions& options, const WindowMemory& memory) {
    WindowOptions window;
    if (memory.width > 0 && memory.height > 0) {
        window.width = memory.width;
        window.height = memory.height;
    }
    if (options.sizeGiven) {  // else it is that of a headless picture
        window.width = options.width;
        window.height = options.height;
    }
    window.debug = options.debugGl;
    return window;
}

/// The window from its first frame to its last.
class Interactive {
  public:
    Interactive(const ViewOptions& options, std::unique_ptr<Scene> scene, const WindowContext& context,
                MemoryFile& memory)
        : window_(context.handle()),
          ui_(window_),
          memory_(memory),
          session_(options, std::move(scene), context.backEnd()),
          slices_([this] { drawAtWork(); }, [this] { return isUnwanted(); }) {
        const WindowMemory& before = memory_.atStart();
        session_.panels.textScale = before.textScale;
        session_.panels.sections = before.sections;
        session_.panels.width = static_cast<float>(before.panelWidth);
        session_.panels.storyClosed = before.storyClosed;
        session_.panels.storyVisible = options.story && !before.storyClosed;
        session_.panels.preview = previewOf(before.preview).value_or(PreviewQuality::Choice::Automatic);
        for (auto path = before.recentScenes.rbegin(); path != before.recentScenes.rend(); ++path)
            session_.recentFiles.add(*path);
        session_.recentFiles.add(session_.scene.name());
    }

    void run() {
        while (glfwWindowShouldClose(window_) == GLFW_FALSE) {
            wait();
            if (!drawWindow(false)) continue;
            replace();
            workInSlices();
        }
        session_.recording.stop(session_);
        memory_.finish();
    }

    Session& session() { return session_; }

  private:
    void wait();
    bool drawWindow(bool atWork);
    void drawAtWork();
    bool isUnwanted();
    void replace();
    void takeInput();
    void drawPanels(Widgets& widgets, const Layout& layout);
    void fitPicture(const Area& area);
    void workInSlices();
    void work();
    void handleSettings();
    void loadSettingsFile();
    void rememberLayout();
    void showTitle();
    void dumpWindow(int width, int height);
    /// The window is drawn at least so often again, whatever happens.
    void drawAgain(int frames) { framesLeft_ = std::max(framesLeft_, frames); }

    GLFWwindow* window_;
    UiWindow ui_;
    MemoryFile& memory_;
    Session session_;
    UiDump dump_;
    FrameLog log_;
    PictureMouse mouse_;
    Slices slices_;
    bool mouseHeld_ = false;
    int framesLeft_ = framesAfterActivity;
    std::size_t keysHandled_ = 0;
    std::size_t framesDrawn_ = 0;
    bool rested_ = false;     ///< there was nothing to do since the last frame
    double drawnAt_ = 0.0;    ///< the last of them, seconds
    double frameTook_ = 0.0;  ///< seconds, of the last one within work
    std::string title_;
};

void Interactive::wait() {
    if (ui_.events().takeActivity()) framesLeft_ = framesAfterActivity;
    const bool minimised = glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE;
    const bool busy = framesLeft_ > 0 || ui_.events().mouse().pending() || session_.moment.playback.playing() ||
                      session_.requests.screenshot || session_.recording.on();
    const double untilWork = std::min({session_.driver.sleep(glfwGetTime()).value_or(longestSleep),
                                       session_.comparison.sleep(glfwGetTime()).value_or(longestSleep), longestSleep});
    rested_ = minimised || (!busy && untilWork > 0.0);
    if (rested_)
        glfwWaitEventsTimeout(minimised ? longestSleep : untilWork);
    else
        glfwPollEvents();
    if (ui_.events().takeActivity()) framesLeft_ = framesAfterActivity;
    framesLeft_ = std::max(0, framesLeft_ - 1);
}

/// A frame of the window, and what its user has done since the last. False where there is nothing to draw into.
/// `atWork`: within a pause of the work, so that nothing is replaced that it refers to.
bool Interactive::drawWindow(bool atWork) {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    if (width <= 0 || height <= 0) return false;
    session_.advance(glfwGetTime(), atWork);
    session_.building = slices_.announced();
    ui_.beginFrame(session_.panels.textScale);
    dump_.beginFrame();
    takeInput();
    const Layout layout =
        layoutOf(ImGui::GetIO().DisplaySize, ui_.scale(), session_.panels.visible, session_.panels.width);
    mouse_.apply(session_, layout.picture);
    Widgets widgets(dump_, ui_.scale(), session_.panels.sections);
    drawPanels(widgets, layout);
    handleSettings();
    rememberLayout();
    fitPicture(layout.picture);
    drawPictureView(session_, widgets, layout.picture);
    if (mouse_.flying()) drawAgain(2);
    mouseHeld_ = mouse_.dragging() || mouse_.flying() || (ImGui::IsAnyItemActive() && ImGui::GetIO().MouseDown[0]);
    showTitle();
    dumpWindow(width, height);
    ui_.endFrame();
    dump_.endFrame();
    drawnAt_ = glfwGetTime();
    const char* const work = !atWork                         ? rested_ ? "rest" : "idle"
                             : session_.driver.drawing()     ? "first"
                             : session_.comparison.drawing() ? "second"
                                                             : "other";
    log_.frame(work, slices_.ended(), slices_.announced());
    return true;
}

void Interactive::drawAtWork() {
    glfwPollEvents();
    const bool heard = ui_.events().takeActivity() || ui_.events().mouse().pending();
    // Where nothing has happened, drawing the window as often as there are slices would only cost time.
    const double now = glfwGetTime();
    const bool due =
        now + secondsOfSlice + frameTook_ >= drawnAt_ + secondsBetweenFrames || !slices_.announced().empty();
    if (heard) drawAgain(framesAfterActivity);
    if (!heard && !due) return;
    const DrawingState state;
    drawWindow(true);
    frameTook_ = glfwGetTime() - now;
}

/// Within a pause: what has been done meanwhile makes the work useless.
bool Interactive::isUnwanted() {
    if (glfwWindowShouldClose(window_) == GLFW_TRUE || session_.requests.replaces() || session_.requests.load)
        return true;
    const FrameDriver::Wanted wanted = session_.wanted(mouseHeld_);
    if (session_.driver.drawing()) return session_.driver.outdated(wanted);
    if (session_.comparison.drawing()) return session_.comparison.outdated(wanted);
    return !session_.driver.follows(wanted) || !session_.comparison.follows(wanted) || session_.probe.outdated();
}

/// What panels and keys have asked to be replaced, between two frames.
void Interactive::replace() {
    if (session_.shaders.watch.changed(session_.now)) session_.requests.reload = true;
    session_.applyRequests();
    loadSettingsFile();
    if (std::exchange(session_.requests.recording, false))
        session_.recording.on() ? session_.recording.stop(session_) : session_.recording.start(session_);
    if (std::exchange(session_.requests.fit, false)) {
        const auto [wide, high] = session_.comparison.missingSize(session_.moment.request);
        ui_.growBy(wide, high);
    }
    if (!mouseHeld_) session_.keepForUndo();
    session_.graph.note(session_.driver.shown());
}

void Interactive::takeInput() {
    for (const std::string& path : ui_.events().takeDropped()) {
        const bool picture = ComparedSide::of(path).kind == ComparedSide::Kind::File;
        (picture ? session_.requests.comparison : session_.requests.scene) = path;
    }
    const std::vector<KeyPress> keys = ui_.events().takeKeys();
    keysHandled_ += keys.size();
    mouse_.press(keys);
    if (applyKeys(session_, keys)) glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Interactive::drawPanels(Widgets& widgets, const Layout& layout) {
    drawSidePanel(session_, widgets, layout.side);
    drawTransportBar(session_, widgets, layout.transport);
    drawOverlays(session_, widgets, layout.picture);
}

void Interactive::fitPicture(const Area& area) {
    const auto pixels = [&](float units) {
        return std::clamp(static_cast<int>(std::lround(units * ui_.pixelsPerUnit())), 1, maximumImageSide);
    };
    session_.moment.request.width = pixels(area.size.x);
    session_.moment.request.height = pixels(area.size.y);
}

/// On a software renderer, whose frames may take seconds. A device that draws beside the program leaves it free.
void Interactive::workInSlices() {
    std::optional<Slices::Work> sliced;
    if (session_.renderer.device().software) sliced.emplace(slices_);
    try {
        work();
    } catch (const WorkCancelled&) {
        drawAgain(2);
    }
}

/// A step of all that is to be drawn, found out and saved.
void Interactive::work() {
    const FrameDriver::Wanted wanted = session_.wanted(mouseHeld_);
    if (session_.driver.update(wanted, session_.now)) drawAgain(2);
    if (session_.comparison.update(session_, wanted)) drawAgain(2);
    if (!session_.recording.on() && session_.probe.update(session_)) drawAgain(2);
    if (session_.recording.update(session_)) drawAgain(2);
    // One after the other: a step of each would make the window slower to respond.
    if (session_.diagnosticPicture.update(session_, session_.moment.request.width) ||
        session_.accuracy.update(session_) || session_.caseStudy.update(session_))
        drawAgain(2);
    if (session_.screenshots.update(session_)) drawAgain(framesAfterActivity);
}

void Interactive::handleSettings() {
    Requests& requests = session_.requests;
    PanelState& panels = session_.panels;
    try {
        if (requests.save) {
            saveSettings(session_, panels.settingsPath);
            session_.notify("Saved " + std::filesystem::absolute(panels.settingsPath).lexically_normal().string());
        }
        if (requests.command) {
            panels.lastCommand = commandOf(session_);
            ImGui::SetClipboardText(panels.lastCommand.c_str());
            session_.notify("Copied: " + panels.lastCommand);
        }
    } catch (const std::exception& error) {
        session_.notify(error.what(), true);
    }
    requests.save = requests.command = false;
}

void Interactive::loadSettingsFile() {
    const std::optional<std::string> path = std::exchange(session_.requests.load, std::nullopt);
    if (!path) return;
    try {
        loadSettings(session_, *path);
        session_.notify("Loaded " + *path);
    } catch (const std::exception& error) {
        session_.notify(error.what(), true);
    }
}

void Interactive::rememberLayout() {
    const PanelState& panels = session_.panels;
    WindowMemory memory;
    memory.textScale = panels.textScale;
    memory.sections = panels.sections;
    memory.recentScenes = session_.recentFiles.paths();
    memory.storyClosed = panels.storyClosed;
    memory.panelWidth = static_cast<double>(panels.width);
    memory.preview = nameOf(panels.preview);
    glfwGetWindowSize(window_, &memory.width, &memory.height);
    memory_.keep(memory, session_.now);
    if (const std::optional<std::string> complaint = memory_.takeComplaint()) session_.notify(*complaint, true);
}

void Interactive::showTitle() {
    const std::string title =
        fmt::format("Timeshade: {}, {}{}", std::filesystem::path(session_.scene.name()).filename().string(),
                    session_.technique.current().description().title,
                    session_.renderer.device().software ? " (software renderer)" : "");
    if (title != title_) glfwSetWindowTitle(window_, title.c_str());
    title_ = title;
}

void Interactive::dumpWindow(int width, int height) {
    if (!dump_.enabled()) return;
    const ImGuiIO& io = ImGui::GetIO();
    dump_.state("window", {width, height});
    dump_.state("scale", ui_.scale());
    dump_.state("keys", keysHandled_);
    dump_.state("frames", ++framesDrawn_);
    dump_.state("slices", {slices_.ended(), slices_.cancelled()});
    dump_.state("waits", gl::waitsSoFar());
    dump_.state("building", slices_.announced());
    dump_.state("mouse", {static_cast<int>(io.MousePos.x), static_cast<int>(io.MousePos.y),
                          io.MouseDown[0] || io.MouseDown[1] || io.MouseDown[2]});
    dumpState(session_, dump_);
    const FrameDriver::Wanted wanted = session_.wanted(mouseHeld_);
    const bool follows = session_.driver.follows(wanted) && session_.comparison.follows(wanted);
    dump_.state("settled", follows && session_.driver.settled() && !session_.requests.replaces());
    dump_.state("compared", follows && session_.comparison.settled(session_));
}

void writeReport(const ViewOptions& options, Session& session) {
    if (options.json.empty() || !session.driver.hasPlan()) return;
    const std::string text = manifest(session.renderer, session.technique.current(), session.scene.name(),
                                      session.scene.current(), session.backEnd, session.driver.times().medians());
    writeFileAtomically(options.json, text);
}

}  // namespace

int runInteractive(const ViewOptions& options) {
    if (options.context.kind == ContextKind::Egl || options.context.kind == ContextKind::OsMesa)
        throw UsageError(
            "--context: the window makes its own context; expected auto or window (egl and osmesa are for headless "
            "commands)");
    requireStrata(options, "the window");
    if (!options.json.empty()) requireWritable(options.json);
    std::unique_ptr<Scene> scene = openScene(options.scene, choiceOf(options), options.settings);
    const FrameRequest request = requestFor(options, *scene);

    MemoryFile memory;
    const WindowContext context(windowOptions(options, memory.atStart()));
    std::optional<gl::DebugLog> log;
    if (options.debugGl) log.emplace();
    {
        Interactive interactive(options, std::move(scene), context, memory);
        Session& session = interactive.session();
        if (options.explain) {
            const Technique& technique = session.technique.current();
            fmt::print("{}", explain(session.scene.planner().plan(technique.asked(request)), technique,
                                     session.renderer.device()));
            std::fflush(stdout);
        }
        interactive.run();
        writeReport(options, session);
    }
    if (log && !log->messages().empty())
        throw Error(
            fmt::format("the driver complained {} times, first: {}", log->messages().size(), log->messages().front()));
    return 0;
}

}  // namespace timeshade
