#include "interactive.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
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
#include "image/image_file.h"
#include "measure/view_scale.h"
#include "panels/comparison_view.h"
#include "panels/panels.h"
#include "report.h"
#include "scene_catalogue.h"
#include "window/controls.h"
#include "window/session.h"
#include "window/settings_io.h"
#include "window/ui_dump.h"
#include "window/ui_window.h"
#include "window/window_memory.h"

namespace timeshade {

namespace {

/// ImGui needs a few frames to show what an event has changed.
constexpr int framesAfterActivity = 3;
constexpr double longestSleep = 0.25;  // seconds; notices end by themselves

WindowOptions windowOptions(const ViewOptions& options, const WindowMemory& memory) {
    WindowOptions window;
    if (memory.width > 0 && memory.height > 0) {
        window.width = memory.width;
        window.height = memory.height;
    }
    // Options start with the size of a headless picture.
    const FrameOptions defaults;
    if (options.width != defaults.width || options.height != defaults.height) {
        window.width = options.width;
        window.height = options.height;
    }
    window.debug = options.debugGl;
    return window;
}

/// The window from its first frame to its last.
class Interactive {
  public:
    Interactive(const PictureOptions& options, std::unique_ptr<Scene> scene, const WindowContext& context,
                MemoryFile& memory)
        : window_(context.handle()),
          ui_(window_),
          memory_(memory),
          session_(options, std::move(scene), context.backEnd()) {
        const WindowMemory& before = memory_.atStart();
        session_.textScale = before.textScale;
        session_.sections = before.sections;
        for (auto path = before.recentScenes.rbegin(); path != before.recentScenes.rend(); ++path)
            session_.remember(*path);
        session_.remember(session_.sceneName);
    }

    void run() {
        while (glfwWindowShouldClose(window_) == GLFW_FALSE) {
            wait();
            int width = 0, height = 0;
            glfwGetFramebufferSize(window_, &width, &height);
            if (width > 0 && height > 0) drawFrame(width, height);
        }
        session_.recording.stop(session_);
        memory_.finish();
    }

    Session& session() { return session_; }

  private:
    void wait();
    void drawFrame(int width, int height);
    void drawPicture(const Area& area);
    void reportState(int width, int height);
    void drawCompared(const gl::Texture& compared, const Area& area);
    void takeScreenshot();
    DisplayImage pictureToSave();
    std::string manifestToSave();
    void handleSettings();
    void keepLayout();

    GLFWwindow* window_;
    UiWindow ui_;
    MemoryFile& memory_;
    Session session_;
    UiDump dump_;
    PictureMouse mouse_;
    int framesLeft_ = framesAfterActivity;
    std::size_t keysHandled_ = 0;
    std::size_t framesDrawn_ = 0;
    std::string title_;
};

void Interactive::wait() {
    if (ui_.events().takeActivity()) framesLeft_ = framesAfterActivity;
    const bool minimised = glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE;
    const bool busy = framesLeft_ > 0 || ui_.events().mouse().pending() || session_.playback.playing() ||
                      session_.wishedScreenshot || session_.recording.on();
    const double untilWork = std::min({session_.driver.sleep(glfwGetTime()).value_or(longestSleep),
                                       session_.comparison.sleep(glfwGetTime()).value_or(longestSleep), longestSleep});
    if (minimised)
        glfwWaitEventsTimeout(longestSleep);
    else if (busy || untilWork <= 0.0)
        glfwPollEvents();
    else
        glfwWaitEventsTimeout(untilWork);
    if (ui_.events().takeActivity()) framesLeft_ = framesAfterActivity;
    framesLeft_ = std::max(0, framesLeft_ - 1);
}

void Interactive::drawFrame(int width, int height) {
    session_.advance(glfwGetTime());
    if (session_.shaderWatch.changed(session_.now)) session_.reloadShaders();
    for (const std::string& path : ui_.events().takeDropped()) session_.wishedScene = path;

    ui_.beginFrame(session_.textScale);
    dump_.beginFrame();
    const std::vector<KeyPress> keys = ui_.events().takeKeys();
    keysHandled_ += keys.size();
    if (applyKeys(session_, keys)) glfwSetWindowShouldClose(window_, GLFW_TRUE);
    const Layout layout = layoutOf(ImGui::GetIO().DisplaySize, ui_.scale(), session_.panelsVisible);
    mouse_.apply(session_, layout.picture);
    Widgets widgets(dump_, ui_.scale(), session_.sections);
    drawSidePanel(session_, widgets, layout.side);
    drawTransportBar(session_, widgets, layout.transport);
    drawOverlays(session_, widgets, layout.picture);
    session_.applyWishes();
    handleSettings();
    keepLayout();

    const auto pixels = [&](float units) {
        return std::clamp(static_cast<int>(std::lround(units * ui_.pixelsPerUnit())), 1, maximumImageSide);
    };
    session_.request.width = pixels(layout.picture.size.x);
    session_.request.height = pixels(layout.picture.size.y);
    const ImGuiIO& io = ImGui::GetIO();
    const bool held = mouse_.dragging() || (ImGui::IsAnyItemActive() && io.MouseDown[0]);
    const FrameDriver::Wanted wanted = session_.wanted(held);
    if (session_.driver.update(wanted, session_.now)) framesLeft_ = std::max(framesLeft_, 2);
    if (session_.comparison.update(session_, wanted)) framesLeft_ = std::max(framesLeft_, 2);
    if (std::exchange(session_.wishedRecording, false))
        session_.recording.on() ? session_.recording.stop(session_) : session_.recording.start(session_);
    if (!session_.recording.on() && session_.probe.update(session_)) framesLeft_ = std::max(framesLeft_, 2);
    if (session_.recording.update(session_)) framesLeft_ = std::max(framesLeft_, 2);
    // One after the other: a step of each would make the window slower to answer.
    if (session_.diagnosticPicture.update(session_, session_.request.width) || session_.accuracy.update(session_))
        framesLeft_ = std::max(framesLeft_, 2);
    if (session_.wishedScreenshot) takeScreenshot();
    if (session_.comparison.on() && session_.comparison.picture() != nullptr)
        drawComparison(session_, widgets, layout.picture);
    else
        drawPicture(layout.picture);
    reportState(width, height);
    ui_.endFrame();
    dump_.endFrame();
}

void Interactive::drawPicture(const Area& area) {
    if (const gl::Texture* compared = session_.diagnosticPicture.picture()) return drawCompared(*compared, area);
    const gl::Texture* picture = session_.driver.picture();
    if (picture == nullptr) return;
    const auto id = reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(picture->name()));
    const ImVec2 end{area.position.x + area.size.x, area.position.y + area.size.y};
    // OpenGL's rows go upwards.
    ImGui::GetBackgroundDrawList()->AddImage(id, area.position, end, {0.0f, 1.0f}, {1.0f, 0.0f});
}

void Interactive::drawCompared(const gl::Texture& compared, const Area& area) {
    const auto width = static_cast<float>(compared.width()), height = static_cast<float>(compared.height());
    const float factor = std::min(area.size.x / width, area.size.y / height);
    const ImVec2 corner{area.position.x + 0.5f * (area.size.x - factor * width),
                        area.position.y + 0.5f * (area.size.y - factor * height)};
    const auto id = reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(compared.name()));
    ImGui::GetBackgroundDrawList()->AddImage(id, corner, {corner.x + factor * width, corner.y + factor * height});
}

DisplayImage Interactive::pictureToSave() {
    if (session_.comparison.on()) return session_.comparison.composedPicture(session_);
    if (session_.diagnosticPicture.complete()) return session_.diagnosticPicture.image();
    const DisplayImage picture = session_.renderer.readPicture();
    return session_.renderer.techniqueView() ? withScale(picture, *session_.renderer.techniqueView()) : picture;
}

std::string Interactive::manifestToSave() {
    if (session_.comparison.on()) return session_.comparison.manifests(session_);
    return manifest(session_.renderer, *session_.technique, session_.sceneName, *session_.scene, session_.backEnd,
                    session_.driver.times().medians());
}

void Interactive::takeScreenshot() {
    using State = FrameDriver::State;
    const State state = session_.driver.state();
    if (state == State::Drawing || (state == State::Complete && session_.driver.preview()))
        return;  // later, when it is whole
    const bool comparing = session_.comparison.on();
    if (comparing && !session_.comparison.settled(session_) && state == State::Complete) return;
    session_.wishedScreenshot = false;
    framesLeft_ = framesAfterActivity;
    if (session_.driver.picture() == nullptr) {
        session_.notify("There is no picture to save.", true);
        return;
    }
    const bool exr = std::exchange(session_.wishedExr, false);
    std::filesystem::path path = std::filesystem::absolute(session_.screenshotName()).lexically_normal();
    if (exr) path.replace_extension(".exr");
    try {
        if (exr)
            writeExr(path,
                     comparing ? session_.comparison.composedRadiance(session_) : session_.renderer.readRadiance());
        else
            writePng(path, pictureToSave(), manifestToSave());
        session_.lastScreenshot = path.string();
        ++session_.screenshots;
        session_.notify("Saved " + path.string());
    } catch (const std::exception& error) {
        session_.notify(error.what(), true);
    }
}

void Interactive::handleSettings() {
    try {
        if (session_.wishedSave) {
            saveSettings(session_, session_.settingsPath);
            session_.notify("Saved " + std::filesystem::absolute(session_.settingsPath).lexically_normal().string());
        }
        if (session_.wishedLoad) {
            loadSettings(session_, *session_.wishedLoad);
            session_.notify("Loaded " + *session_.wishedLoad);
        }
        if (session_.wishedCommand) {
            session_.lastCommand = commandOf(session_);
            ImGui::SetClipboardText(session_.lastCommand.c_str());
            session_.notify("Copied: " + session_.lastCommand);
        }
    } catch (const std::exception& error) {
        session_.notify(error.what(), true);
    }
    session_.wishedSave = session_.wishedCommand = false;
    session_.wishedLoad.reset();
}

void Interactive::keepLayout() {
    WindowMemory memory{0, 0, session_.textScale, session_.sections, session_.recentScenes};
    glfwGetWindowSize(window_, &memory.width, &memory.height);
    memory_.keep(memory, session_.now);
    if (const std::optional<std::string> complaint = memory_.takeComplaint()) session_.notify(*complaint, true);
}

void Interactive::reportState(int width, int height) {
    const FrameDriver& driver = session_.driver;
    const std::string title = fmt::format(
        "Timeshade: {}, {}{}", std::filesystem::path(session_.sceneName).filename().string(),
        session_.technique->description().title, session_.renderer.device().software ? " (software renderer)" : "");
    if (title != title_) glfwSetWindowTitle(window_, title.c_str());
    title_ = title;
    if (!dump_.enabled()) return;
    static constexpr const char* names[] = {"nothing", "drawing", "complete", "cancelled", "failed"};
    dump_.state("window", {width, height});
    dump_.state("scale", ui_.scale());
    dump_.state("scene", session_.sceneName);
    dump_.state("clip", session_.scene->clips().empty() ? "" : session_.scene->clips()[session_.scene->clip()]);
    dump_.state("technique", session_.technique->description().name);
    dump_.state("frame", session_.playback.frame());
    dump_.state("playing", session_.playback.playing());
    dump_.state("hand_camera", session_.camera.has_value());
    dump_.state("picture", names[static_cast<int>(driver.state())]);
    dump_.state("settled", driver.settled());
    dump_.state("preview", driver.preview());
    dump_.state("begun", driver.begun());
    if (driver.hasPlan()) {
        const FrameRequest& drawn = session_.renderer.plan().request;
        dump_.state("drawn", {drawn.width, drawn.height});
        dump_.state("renders", {session_.renderer.rendersDone(), session_.renderer.renders()});
    }
    if (driver.state() == FrameDriver::State::Failed) dump_.state("failure", driver.failure());
    static constexpr const char* diagnostics[] = {"none", "error", "disagreement"};
    dump_.state("view", session_.viewName());
    dump_.state("diagnostic", {diagnostics[static_cast<int>(session_.diagnostic)],
                               driver.settled() && session_.diagnosticPicture.complete()});
    dump_.state("screenshot", session_.lastScreenshot);
    dump_.state("compare",
                session_.comparison.on() ? session_.comparison.variants(session_) : std::vector<std::string>{});
    dump_.state("compared", session_.comparison.settled(session_));
    dump_.state("seam", session_.comparison.seam);
    dump_.state("instant", session_.instant.value_or(-1.0));
    dump_.state("recording", {session_.recording.on(), session_.recording.frames()});
    dump_.state("recorded", session_.recording.lastPath());
    dump_.state("shader_log", session_.shaderLog);
    dump_.state("shaders", session_.shaderNumber);
    dump_.state("probe", {session_.probe.on(), session_.probe.complete()});
    dump_.state("saved", session_.screenshots);
    dump_.state("command", session_.lastCommand);
    dump_.state("panels", session_.panelsVisible);
    dump_.state("keys", keysHandled_);
    dump_.state("frames", ++framesDrawn_);
    const ImGuiIO& io = ImGui::GetIO();
    dump_.state("mouse", {static_cast<int>(io.MousePos.x), static_cast<int>(io.MousePos.y),
                          io.MouseDown[0] || io.MouseDown[1] || io.MouseDown[2]});
}

void writeReport(const ViewOptions& options, Session& session) {
    if (options.json.empty() || !session.driver.hasPlan()) return;
    const std::string text = manifest(session.renderer, *session.technique, session.sceneName, *session.scene,
                                      session.backEnd, session.driver.times().medians());
    writeFileAtomically(options.json, text);
}

}  // namespace

int runInteractive(const ViewOptions& options) {
    if (options.context.kind == ContextKind::Egl || options.context.kind == ContextKind::OsMesa)
        throw UsageError(
            "--context: the window makes its own context; expected auto or window (egl and osmesa are for headless "
            "commands)");
    if (!options.json.empty()) requireWritable(options.json);
    std::unique_ptr<Scene> scene = openScene(options.scene, options.clip, options.settings);
    const FrameRequest request = requestFor(options, *scene);

    MemoryFile memory;
    const WindowContext context(windowOptions(options, memory.atStart()));
    std::optional<gl::DebugLog> log;
    if (options.debugGl) log.emplace();
    {
        Interactive interactive(options, std::move(scene), context, memory);
        Session& session = interactive.session();
        if (options.explain) {
            fmt::print("{}", explain(session.planner->plan(request), *session.technique, session.renderer.device()));
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
