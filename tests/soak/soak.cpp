// Thousands of random changes of scene, technique, settings and sizes, one after the other on one renderer, as somebody who
// plays with the window for hours: nothing may fail, no buffer may hold a NaN, and memory may not grow.
//   soak CHANGES [SEED]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

#include <malloc.h>

#include <fmt/format.h>

#include "contexts/gl_context.h"
#include "frame/frame_renderer.h"
#include "gl/debug_log.h"
#include "scene_catalogue.h"
#include "support/awkward_numbers.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

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

/// What is in use once the allocator has given back what it only keeps.
std::size_t residentBytes() {
    malloc_trim(0);
    return statusBytes("VmRSS");
}

/// Any allowed value, more often a small one.
void setAtRandom(const Setting& setting, AwkwardNumbers& numbers) {
    if (setting.isSwitch())
        Setting(setting).set(numbers.oneIn(2) ? 1.0 : 0.0);
    else if (setting.isWhole())
        // The largest values of some settings take minutes; eight apart is as random.
        Setting(setting).set(setting.minimum + numbers.below(static_cast<std::uint32_t>(std::min(setting.maximum - setting.minimum, 7.0)) + 1));
    else
        Setting(setting).set(setting.minimum + (setting.maximum - setting.minimum) * std::pow(static_cast<double>(numbers.unit()), 3.0));
}

class Soak {
  public:
    Soak(std::uint32_t seed) : numbers_(seed), context_(makeHeadlessContext({ContextKind::Egl, -1, true})) {
        for (const TechniqueDescription& description : techniqueDescriptions()) techniqueNames_.push_back(description.name);
        sceneNames_ = {"pillars", "chess"};
        for (const BuiltInScene& scene : caseScenes()) sceneNames_.push_back(scene.name);
        request_.width = 64;
        request_.height = 48;
        request_.samplesPerPixel = 4;
        request_.mapSize = 64;
        renderer_.emplace();
        renderer_->setChecked(true);
        openScene(sceneNames_.front());
        chooseTechnique(techniqueNames_.front());
    }

    /// The `i`th of the first changes: everything at its largest, so that what comes later can't need more unless it is lost. All
    /// pairs of technique and file, in turn, with other settings each time.
    void changeToLargest(int i) {
        const auto number = static_cast<std::size_t>(i);
        if (i % 2 == 0) chooseTechnique(techniqueNames_[number / 2 % techniqueNames_.size()]);
        openScene(sceneNames_[number % fileScenes]);
        for (const Setting& setting : settingsOf(*technique_)) setAtRandom(setting, numbers_);
        request_.width = largestWidth;
        request_.height = largestHeight;
        request_.samplesPerPixel = largestSamples;
        request_.mapSize = smallestMap << (mapSteps - 1);
        draw();
    }

    /// One change, and the frame after it.
    void change() {
        switch (numbers_.below(6)) {
        case 0: openScene(sceneNames_[numbers_.below(static_cast<std::uint32_t>(sceneNames_.size()))]); break;
        case 1: chooseTechnique(techniqueNames_[numbers_.below(static_cast<std::uint32_t>(techniqueNames_.size()))]); break;
        case 2:
            for (const Setting& setting : settingsOf(*technique_)) setAtRandom(setting, numbers_);
            break;
        case 3:
            request_.width = 1 + static_cast<int>(numbers_.below(largestWidth));
            request_.height = 1 + static_cast<int>(numbers_.below(largestHeight));
            break;
        case 4:
            request_.samplesPerPixel = 1 + static_cast<int>(numbers_.below(largestSamples));
            request_.mapSize = smallestMap << numbers_.below(mapSteps);
            break;
        default:
            request_.frame = static_cast<double>(numbers_.below(48));
            request_.seed = numbers_.word();
            request_.shutter.length = static_cast<double>(numbers_.unit());
            break;
        }
        draw();
    }

    std::string now() const {
        return fmt::format("{} in {}, {} x {}, {} spp, map {}", technique_->description().name, sceneName_, request_.width, request_.height,
                           request_.samplesPerPixel, request_.mapSize);
    }

  private:
    static constexpr int largestWidth = 64, largestHeight = 48, largestSamples = 8, smallestMap = 16, mapSteps = 5;
    static constexpr std::size_t fileScenes = 2;

    void draw() {
        const FramePlan plan = planner_->plan(request_);
        if (!technique_->unsupported(plan)) renderer_->draw(plan, *technique_, numbers_.oneIn(2) ? View::Final : View::Visibility);
        renderer_->timer().finishFrame();
        if (!log_.messages().empty()) throw std::runtime_error("the driver complains: " + log_.messages().front());
    }

    void openScene(const std::string& name) {
        planner_.reset();
        scene_.reset();  // so that two of the largest are never there at once
        scene_ = timeshade::openScene(name, "");
        planner_.emplace(*scene_);
        sceneName_ = name;
        request_.frame = 0.0;
        request_.shutter = {scene_->defaults().framesPerSecond, scene_->defaults().shutterLength, ShutterPosition::Start};
    }
    void chooseTechnique(const std::string& name) {
        technique_ = makeTechnique(name, renderer_->programs());
        if (name == "accumulation") setFromText(*technique_, "renders", "4");
    }

    AwkwardNumbers numbers_;
    std::unique_ptr<GlContext> context_;
    gl::DebugLog log_;
    std::optional<FrameRenderer> renderer_;
    std::vector<std::string> techniqueNames_, sceneNames_;
    std::unique_ptr<Scene> scene_;
    std::optional<FramePlanner> planner_;
    std::unique_ptr<Technique> technique_;
    std::string sceneName_;
    FrameRequest request_;
};

int run(int changes, std::uint32_t seed, double allowedGrowth) {
    Soak soak(seed);
    std::size_t peakAtFirst = 0, residentAtFirst = 0;
    const int first = 100;
    for (int i = 0; i < changes; ++i) {
        try {
            i < first ? soak.changeToLargest(i) : soak.change();
        } catch (const std::exception& error) {
            fmt::print(stderr, "change {}: {}: {}\n", i, soak.now(), error.what());
            return 1;
        }
        if (i + 1 == first) {
            peakAtFirst = statusBytes("VmHWM");
            residentAtFirst = residentBytes();
        }
    }
    const std::size_t peak = statusBytes("VmHWM"), resident = residentBytes();
    const double growth = 100.0 * (static_cast<double>(peak) / static_cast<double>(peakAtFirst) - 1.0);
    fmt::print("{} changes: peak {:.1f} MiB after {}, {:.1f} MiB at the end ({:+.2f} %); resident {:.1f} and {:.1f} MiB\n", changes,
               static_cast<double>(peakAtFirst) / 1048576.0, first, static_cast<double>(peak) / 1048576.0, growth,
               static_cast<double>(residentAtFirst) / 1048576.0, static_cast<double>(resident) / 1048576.0);
    return growth <= allowedGrowth ? 0 : 1;
}

} // namespace
} // namespace timeshade

int main(int argumentCount, char** arguments) {
    // Large blocks go back to the system when they are freed, so that holes between small ones don't count as growth.
    mallopt(M_MMAP_THRESHOLD, 128 * 1024);
    mallopt(M_TRIM_THRESHOLD, 128 * 1024);
    mallopt(M_ARENA_MAX, 1);
    const int changes = argumentCount > 1 ? std::atoi(arguments[1]) : 2000;
    const double allowedGrowth = argumentCount > 3 ? std::atof(arguments[3]) : 2.0;  // per cent of the peak after 100 changes
    return timeshade::run(changes, argumentCount > 2 ? static_cast<std::uint32_t>(std::atoi(arguments[2])) : 1u, allowedGrowth);
}
