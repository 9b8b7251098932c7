// Thousands of random changes of scene, technique, settings, views and sizes, one after the other, as somebody makes
// them who plays with the window for hours. The window's own state and frame driver are driven, and its panels laid
// out, without a display; only the drawing of ImGui's triangles is left out. Nothing may fail, no buffer may hold a
// NaN, and memory may not grow, which takes as many changes as fill all caches.
//   soak [CHANGES [SEED [PER CENT]]]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

#include <malloc.h>

#include <fmt/format.h>
#include <imgui.h>

#include "contexts/gl_context.h"
#include "gl/debug_log.h"
#include "panels/panels.h"
#include "scene_catalogue.h"
#include "support/awkward_numbers.h"
#include "support/thorough.h"
#include "techniques/registry.h"
#include "window/session.h"

namespace timeshade {
namespace {

constexpr double allowedRestGrowth = 25.0;  // per cent

double mebibytes(std::size_t bytes) { return static_cast<double>(bytes) / (1024.0 * 1024.0); }

/// Bytes of a line of /proc/self/status.
std::size_t statusBytes(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == key + ":") {
            std::size_t kilobytes = 0;
            status >> kilobytes;
            return kilobytes * 1024;
        }
    return 0;
}

/// What was asked of the allocator and not given back: without what it only keeps.
std::size_t allocatedBytes() {
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

/// Any allowed value, more often a small one.
void setAtRandom(const Setting& setting, AwkwardNumbers& numbers) {
    if (setting.isSwitch())
        Setting(setting).set(numbers.oneIn(2) ? 1.0 : 0.0);
    else if (setting.isWhole())
        // The largest values of some settings take minutes; eight apart is as random.
        Setting(setting).set(
            setting.minimum +
            numbers.below(static_cast<std::uint32_t>(std::min(setting.maximum - setting.minimum, 7.0)) + 1));
    else
        Setting(setting).set(setting.minimum +
                             (setting.maximum - setting.minimum) * std::pow(static_cast<double>(numbers.unit()), 3.0));
}

PictureOptions firstOptions() {
    PictureOptions options;
    options.scene = "pillars";
    options.samplesPerPixel = 4;
    options.mapSize = 64;
    return options;
}

/// ImGui without a window to show it in.
class HeadlessPanels {
  public:
    HeadlessPanels() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {1000.0f, 700.0f};
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    }
    HeadlessPanels(const HeadlessPanels&) = delete;
    HeadlessPanels& operator=(const HeadlessPanels&) = delete;
    ~HeadlessPanels() { ImGui::DestroyContext(); }

    void draw(Session& session) {
        ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
        ImGui::NewFrame();
        const Layout layout = layoutOf(ImGui::GetIO().DisplaySize, 1.0f, true);
        Widgets widgets(dump_, 1.0f, session.panels.sections);
        drawSidePanel(session, widgets, layout.side);
        drawTransportBar(session, widgets, layout.transport);
        drawOverlays(session, widgets, layout.picture);
        ImGui::Render();
    }

  private:
    UiDump dump_;
};

class Soak {
  public:
    /// Of so many changes.
    Soak(std::uint32_t seed, int changes)
        : numbers_(seed),
          context_(makeHeadlessContext({ContextKind::Egl, -1, true})),
          session_(firstOptions(), openScene("pillars", ""), "soak") {
        for (const TechniqueDescription& description : techniqueDescriptions())
            techniqueNames_.push_back(description.name);
        sceneNames_ = {"pillars", "chess"};
        for (const BuiltInScene& scene : caseScenes()) sceneNames_.push_back(scene.name);
        session_.renderer.setChecked(true);
        fills_ = changes > 4 * 3 * static_cast<int>(techniqueNames_.size());
    }

    /// How many first changes go through all that is heavy. Of each technique four in each of three scenes, one where
    /// there are too few changes for that.
    int warmUp() const { return (fills_ ? 4 : 1) * 3 * static_cast<int>(techniqueNames_.size()); }
    /// Have the first changes filled all that may be filled, so that memory may not grow after them?
    bool fills() const { return fills_; }

    /// The `i`th of the first changes: everything at its largest, so that what comes later can't need more unless
    /// something is lost. All techniques, each in the two files and in the case with the longest lists, before any
    /// comes again; their first settings first, then every second switch the other way, then anything.
    void changeToLargest(int i) {
        static const char* const heavyScenes[] = {crowdScene, "chess", "pillars"};
        const auto number = static_cast<std::size_t>(i);
        const std::size_t techniques = techniqueNames_.size(), round = number / (3 * techniques);
        session_.requests.technique = techniqueNames_[number % techniques];
        session_.requests.scene = heavyScenes[number / techniques % 3];
        // Seconds a picture with some techniques: as a rule each meets it once.
        if (usualOrAll(round, std::size_t(0)) > 0 && session_.requests.scene == crowdScene)
            session_.requests.scene = "chess";
        session_.applyRequests();
        for (const Setting& setting : settingsOf(session_.technique.current())) {
            if (round == 1 && setting.isSwitch())
                Setting(setting).set(1.0 - setting.defaultValue);
            else if (round > 1)
                setAtRandom(setting, numbers_);
        }
        holdDownBruteForce();
        if (round == 2) moveLight(session_.moment.request.light);
        // Both kinds of size: software renderers compile a shader anew for textures whose sides are no powers of two.
        width_ = i % 2 == 0 ? largestWidth : largestWidth - 1;
        height_ = largestHeight - i % 3;
        session_.moment.request.samplesPerPixel = maxSamples;
        session_.moment.request.mapSize = smallestMap << (mapSteps - 1);
        draw(false);
    }

    /// One change, and the frame after it.
    void change() {
        Session& s = session_;
        bool moving = false;
        switch (numbers_.below(9)) {
        case 0: s.requests.scene = sceneNames_[numbers_.below(static_cast<std::uint32_t>(sceneNames_.size()))]; break;
        case 1:
            s.requests.technique = techniqueNames_[numbers_.below(static_cast<std::uint32_t>(techniqueNames_.size()))];
            break;
        case 2:
            for (const Setting& setting : settingsOf(s.technique.current())) setAtRandom(setting, numbers_);
            break;
        case 3:
            width_ = 1 + static_cast<int>(numbers_.below(largestWidth));
            height_ = 1 + static_cast<int>(numbers_.below(largestHeight));
            break;
        case 4:
            s.moment.request.samplesPerPixel = 1 + static_cast<int>(numbers_.below(maxSamples));
            s.moment.request.mapSize = smallestMap << numbers_.below(mapSteps);
            break;
        case 5: {
            const std::vector<std::string> views = viewNames(s.technique.current());
            s.view.show(views[numbers_.below(static_cast<std::uint32_t>(views.size()))]);
            break;
        }
        case 6:
            if (numbers_.oneIn(2))
                s.camera.useSceneCamera(s.moment, 0);
            else
                s.camera.take(s.scene.current(), s.moment)
                    .orbit(static_cast<double>(numbers_.between(-1.0f, 1.0f)),
                           static_cast<double>(numbers_.between(-0.3f, 0.3f)));
            moving = true;
            break;
        case 7: changeLightAndGround(); break;
        default: {
            s.moment.playback.jump(static_cast<double>(numbers_.below(48)));
            s.moment.request.seed = numbers_.word();
            Shutter shutter = s.moment.request.shutter;
            shutter.length = static_cast<double>(numbers_.unit());
            s.moment.setShutter(shutter, s.scene.current().duration());
            break;
        }
        }
        s.applyRequests();
        holdDownBruteForce();
        draw(moving);
    }

    /// Something small, always the same: what is held then is what caches hold, and what was lost.
    void rest() {
        session_.requests.technique = "static";
        session_.requests.scene = "case:static_all";
        session_.applyRequests();
        session_.view.show("final");
        for (const Setting& setting : settingsOf(session_.technique.current()))
            Setting(setting).set(setting.defaultValue);
        width_ = height_ = smallestMap;
        session_.moment.request.mapSize = smallestMap;
        session_.moment.request.samplesPerPixel = 1;
        draw(false);
    }

    std::string now() const {
        const FrameRequest& r = session_.moment.request;
        return fmt::format("{} in {}, view {}, {} x {}, {} spp, map {}", session_.technique.name(),
                           session_.scene.name(), session_.view.name(), r.width, r.height, r.samplesPerPixel,
                           r.mapSize.text());
    }

  private:
    /// A thousand casters over every texel: at the largest map their lists are so large that a leak could hide below
    /// their peak.
    static constexpr const char* crowdScene = "case:many_slivers";
    const int maxCrowdMap = usualOrAll(16, 32);
    static constexpr int largestWidth = 64, largestHeight = 48, maxSamples = 8, smallestMap = 16, mapSteps = 4;

    /// Turns and moves the light, or leaves it as the scene has it; a ground, or none, below what has meshes of a file.
    void changeLightAndGround() {
        LightChange light;
        if (numbers_.oneIn(2)) {
            moveLight(light);
            light.direction = LightDirection{static_cast<double>(numbers_.between(-180.0f, 180.0f)),
                                             static_cast<double>(numbers_.between(10.0f, 80.0f))};
            light.intensity = static_cast<double>(numbers_.between(0.1f, 3.0f));
        }
        session_.moment.request.light = light;
        GroundSettings ground;
        ground.choice = static_cast<GroundChoice>(numbers_.below(3));
        session_.requests.ground = ground;
    }

    /// By some degrees a frame, and a spot sideways: everything moves then as the light sees it.
    void moveLight(LightChange& light) {
        light.turn = static_cast<double>(numbers_.between(-20.0f, 20.0f));
        light.rise = static_cast<double>(numbers_.between(-5.0f, 5.0f));
        const Scene& scene = session_.scene.current();
        if (scene.light(0.0).kind == LightKind::Spot)
            light.move.x = 0.1 * scene.bounds().diagonal() * static_cast<double>(numbers_.unit());
    }

    void holdDownBruteForce() {
        if (session_.technique.name() == "accumulation") setFromText(session_.technique.current(), "renders", "4");
    }

    /// Goes round the window's loop, from where wishes have been granted, until the picture is whole, and looks for
    /// what went wrong.
    void draw(bool moving) {
        if (!session_.panels.sceneError.empty()) throw std::runtime_error(session_.panels.sceneError);
        clock_ += 1.0;  // longer than the window waits for the mouse to come to rest
        for (int round = 0; round < 100; ++round) {
            clock_ += 0.02;
            session_.advance(clock_);
            session_.moment.request.width = width_;
            session_.moment.request.height = height_;
            if (session_.scene.name() == crowdScene)
                session_.moment.request.mapSize = std::min(session_.moment.request.mapSize.longerSide(), maxCrowdMap);
            session_.driver.update(session_.wanted(moving && round < 2), session_.now);
            panels_.draw(session_);
            if (session_.driver.state() == FrameDriver::State::Failed) {
                refuseAllBut(session_.driver.failure());
                break;
            }
            if (session_.driver.settled() && round >= 2) break;
            clock_ += 1.0;
        }
        if (!log_.messages().empty()) throw std::runtime_error("the driver complains: " + log_.messages().front());
    }

    /// A technique may say that it does not draw a frame; nothing else may fail.
    void refuseAllBut(const std::string& failure) const {
        if (failure.rfind("technique " + session_.technique.name() + " can't draw this frame", 0) != 0)
            throw std::runtime_error(failure);
    }

    AwkwardNumbers numbers_;
    bool fills_ = false;
    std::unique_ptr<GlContext> context_;
    gl::DebugLog log_;
    HeadlessPanels panels_;
    Session session_;
    std::vector<std::string> techniqueNames_, sceneNames_;
    int width_ = largestWidth, height_ = largestHeight;
    double clock_ = 0.0;
};

struct Memory {
    std::size_t peak = 0, atRest = 0;
};

Memory memoryOf(Soak& soak) {
    const std::size_t peak = statusBytes("VmHWM");
    soak.rest();
    return {peak, allocatedBytes()};
}

int run(int changes, std::uint32_t seed, double allowedGrowth) {
    Soak soak(seed, changes);
    Memory first;
    for (int i = 0; i < changes; ++i) {
        try {
            i < soak.warmUp() ? soak.changeToLargest(i) : soak.change();
        } catch (const std::exception& error) {
            fmt::print(stderr, "change {}: {}: {}\n", i, soak.now(), error.what());
            return 1;
        }
        if (i + 1 == soak.warmUp()) first = memoryOf(soak);
    }
    const Memory last = memoryOf(soak);
    const double growth = 100.0 * (static_cast<double>(last.peak) / static_cast<double>(first.peak) - 1.0);
    fmt::print(
        "{} changes: peak {:.1f} MiB after {}, {:.1f} MiB at the end ({:+.2f} %); allocated at rest {:.1f} and {:.1f} "
        "MiB\n",
        changes, mebibytes(first.peak), soak.warmUp(), mebibytes(last.peak), growth, mebibytes(first.atRest),
        mebibytes(last.atRest));
    // Which of the programs are held, and with how many kinds of textures they have met, is chance: some megabytes.
    const double restGrowth = 100.0 * (static_cast<double>(last.atRest) / static_cast<double>(first.atRest) - 1.0);
    if (!soak.fills()) return 0;
    return growth <= allowedGrowth && restGrowth <= allowedRestGrowth ? 0 : 1;
}

}  // namespace
}  // namespace timeshade

int main(int argumentCount, char** arguments) {
    // Large blocks go back to the system when they are freed, so that holes between small ones don't count as growth.
    mallopt(M_MMAP_THRESHOLD, 128 * 1024);
    mallopt(M_TRIM_THRESHOLD, 128 * 1024);
    mallopt(M_ARENA_MAX, 1);
    const int drawn = timeshade::testedShare() == timeshade::TestedShare::All ? 400 : timeshade::usualOrAll(80, 200);
    const int changes = argumentCount > 1 ? std::atoi(arguments[1]) : drawn;
    const double allowedGrowth =
        argumentCount > 3 ? std::atof(arguments[3]) : 2.0;  // per cent of the peak after the warm-up
    return timeshade::run(changes, argumentCount > 2 ? static_cast<std::uint32_t>(std::atoi(arguments[2])) : 1u,
                          allowedGrowth);
}
