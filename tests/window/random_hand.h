#pragma once

#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "techniques/registry.h"
#include "window/session.h"

namespace timeshade {

/// Changes something about a session, as panels and keys do.
class RandomHand {
  public:
    /// `techniques`: those that it chooses from; empty for all. `file`: a picture that it may compare with; empty for
    /// none.
    RandomHand(Session& session, unsigned seed, std::vector<std::string> techniques = {}, std::string file = {})
        : session_(session), random_(seed), techniques_(std::move(techniques)), file_(std::move(file)) {
        if (!techniques_.empty()) return;
        for (const TechniqueDescription& description : techniqueDescriptions()) techniques_.push_back(description.name);
    }

    /// A whole number from 0 to `most`.
    int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }

    void change() {
        const std::vector<std::function<void()>> ways{
            [&] { session_.requests.technique = anyTechnique(); },
            [&] { session_.requests.comparison = anyPartner(); },
            [&] { session_.requests.swap = true; },
            [&] { session_.comparison.seam = share(); },
            [&] { session_.comparison.mode = static_cast<CompareMode>(upTo(2)); },
            [&] { session_.comparison.flip = !session_.comparison.flip; },
            [&] { session_.comparison.gain = 1 + upTo(254); },
            [&] { session_.requests.snapshot = true; },
            [&] { changeSetting(session_.technique.current()); },
            [&] { changeSetting(session_.technique.current()); },
            [&] { changeScene(); },
            [&] { session_.moment.request.samplesPerPixel = 1 + upTo(31); },
            [&] { session_.moment.request.mapSize = 64 << upTo(5); },
            [&] { session_.moment.request.seed = static_cast<std::uint32_t>(upTo(100)); },
            [&] { session_.moment.request.pixelCentres = !session_.moment.request.pixelCentres; },
            [&] { session_.moment.request.motionSteps = 1 << upTo(3); },
            [&] { changeShutter(); },
            [&] { session_.moment.instant = upTo(1) == 0 ? std::optional(share()) : std::nullopt; },
            [&] { session_.moment.playback.setSpeed(0.01 + 0.99 * share()); },
            [&] { moveCamera(); },
            [&] { session_.camera.useSceneCamera(session_.moment, 0); },
            [&] { session_.view.light = upTo(1) == 0 ? View::Final : View::Visibility; },
            [&] { session_.panels.textScale = 0.75 + share(); },
            [&] { session_.panels.preview = static_cast<PreviewQuality::Choice>(upTo(2)); },
            [&] { session_.requests.scene = upTo(1) == 0 ? "cubes" : "pillars"; }};
        ways[static_cast<std::size_t>(upTo(static_cast<int>(ways.size()) - 1))]();
        session_.applyRequests();
    }

  private:
    double share() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
    std::string anyTechnique() {
        return techniques_[static_cast<std::size_t>(upTo(static_cast<int>(techniques_.size()) - 1))];
    }
    std::string anyPartner() {
        switch (upTo(6)) {
        case 0: return "";
        case 1: return "truth";
        case 2: return file_.empty() ? anyTechnique() : file_;
        case 3: return anyTechnique() + fmt::format(":spp={}", 1 + upTo(31));
        default: return anyTechnique();
        }
    }
    void changeSetting(HasSettings& owner) {
        std::vector<Setting> settings = settingsOf(owner);
        if (settings.empty()) return;
        Setting& setting = settings[static_cast<std::size_t>(upTo(static_cast<int>(settings.size()) - 1))];
        setting.set(setting.minimum + share() * (setting.maximum - setting.minimum));
    }
    void changeScene() {
        if (session_.scene.recipe() == nullptr) return;
        changeSetting(*session_.scene.recipe());
        for (Setting& setting : settingsOf(*session_.scene.recipe()))
            if (setting.isWhole() && setting.get() > mostThings) setting.set(mostThings);
        session_.requests.rebuild = true;
    }
    void changeShutter() {
        Shutter shutter = session_.moment.request.shutter;
        shutter.length = 2.0 * share();
        shutter.position = static_cast<ShutterPosition>(upTo(2));
        shutter.response = static_cast<ShutterResponse>(upTo(2));
        shutter.framesPerSecond = 1.0 + 100.0 * share();
        session_.moment.setShutter(shutter, session_.scene.current().duration());
    }
    void moveCamera() {
        OrbitCamera& camera = session_.camera.take(session_.scene.current(), session_.moment);
        camera.orbit(share() - 0.5, share() - 0.5);
        camera.zoom(0.5 + share());
    }

    static constexpr double mostThings = 30.0;  // of a scene: thousands would only take longer to draw

    Session& session_;
    std::mt19937 random_;
    std::vector<std::string> techniques_;
    std::string file_;
};

}  // namespace timeshade
