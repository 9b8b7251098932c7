#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/compare_mode.h"
#include "gl/texture.h"
#include "window/accuracy_probe.h"
#include "window/frame_driver.h"

namespace timeshade {

struct Session;

/// The second technique of a comparison in the window: drawn of the same moment, with the same samples, by a renderer
/// of its own; and what both halves cost and how wrong they are.
class Comparison {
  public:
    bool on() const { return technique_ != nullptr; }
    /// Takes a technique with its settings as the second one. Null ends the comparison.
    void choose(std::unique_ptr<Technique> technique);
    Technique* technique() const { return technique_.get(); }
    /// Exchanges the two, so that the panel's sliders are the other's.
    void swap(Session& session);

    /// As ProgramCache::reload, for the second's passes.
    std::vector<std::string> reloadShaders() {
        return renderer_ ? renderer_->reloadShaders() : std::vector<std::string>{};
    }

    /// As FrameRenderer::invalidateAll, for the second's frames.
    void invalidateAll() {
        if (renderer_) renderer_->invalidateAll();
    }

    /// Draws the second picture, then, when nothing moves, finds the errors, a step at a time. True if the window has
    /// to be drawn again.
    bool update(Session& session, const FrameDriver::Wanted& first);

    /// As FrameDriver::outdated and drawing, for the second picture.
    bool outdated(const FrameDriver::Wanted& first) const {
        return driver_ && driver_->outdated(wantedOfSecond(first));
    }
    bool drawing() const { return driver_ && driver_->drawing(); }
    /// As FrameDriver::follows; true as long as there is no second picture.
    bool follows(const FrameDriver::Wanted& first) const;

    /// Null as long as there is none.
    const gl::Texture* picture() const { return on() && driver_ ? driver_->picture() : nullptr; }
    /// The difference of both, once they are whole; null before and in other modes.
    const gl::Texture* difference() const { return difference_ ? &*difference_ : nullptr; }
    /// As FrameDriver's, for the second picture.
    void warmUp() {
        if (driver_) driver_->warmUp();
    }
    void cancel() {
        if (driver_) driver_->cancel();
    }
    void resume() {
        if (driver_) driver_->resume();
    }
    void hurry() {
        if (driver_) driver_->hurry();
    }
    void drawUncached() {
        if (driver_) driver_->drawUncached();
    }
    void setPreview(PreviewQuality::Choice choice) {
        if (driver_) driver_->setPreview(choice);
    }
    std::optional<double> progress() const { return driver_ ? driver_->progress() : std::nullopt; }
    /// What the second picture is; null as long as there is none.
    const ShownPicture* shown() const { return picture() != nullptr ? &driver_->shown() : nullptr; }
    /// Both are all that they can be.
    bool settled(const Session& session) const;
    /// Seconds that the window may sleep; nothing if only a change can bring work.
    std::optional<double> sleep(double now) const;

    /// Of the picture that is shown: "TSM, 8 spp, map 1024, shadow error 0.012, 12.3 ms"; what is not known yet is left
    /// out, and a preview has no error: "TSM, 2 spp, map 1024, preview, 45 ms".
    std::string label(const Session& session, bool ofSecond) const;
    /// The two as --compare takes them: "tsm", "ranges:bias=2".
    std::vector<std::string> variants(Session& session) const;
    /// Both as one picture, as `shot --compare` draws it.
    DisplayImage composedPicture(Session& session);
    LinearImage composedRadiance(Session& session);
    /// Manifests of both, as `shot --compare --json` writes them.
    std::string manifests(Session& session);

    CompareMode mode = CompareMode::Wipe;
    bool flip = false;  ///< instead of the mode: one of them alone, the other while a key is held
    bool flipped = false;
    double seam = 0.5;

  private:
    FrameDriver::Wanted wantedOfSecond(const FrameDriver::Wanted& first) const;
    bool updateDifference(Session& session);
    bool updateErrors(Session& session);

    std::optional<FrameRenderer> renderer_;  ///< made when first needed
    std::optional<FrameDriver> driver_;
    std::unique_ptr<Technique> technique_;
    int number_ = 0;  ///< changes with the technique
    std::optional<gl::Texture> difference_;
    int differenceOf_[2] = {-1, -1};  ///< pictures, by their numbers
    AccuracyProbe probe_;
    std::vector<ProbePoint> points_;
    std::vector<double> pointsOf_;  ///< the moment that they are of, as momentKeyOf
};

/// A technique as --compare takes it, with those of its settings that are not at their defaults.
std::string variantOf(Technique& technique);

}  // namespace timeshade
