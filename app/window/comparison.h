#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/compare_mode.h"
#include "compare/compared_side.h"
#include "compare/file_picture.h"
#include "gl/texture.h"
#include "scene_catalogue.h"
#include "window/accuracy_probe.h"
#include "window/frame_driver.h"
#include "window/picture_difference.h"
#include "window/truth_refinement.h"

namespace timeshade {

struct Session;

/// Side B of the window's comparison: a second technique, drawn of the same moment, with the same samples unless it has
/// its own, by a renderer of its own; the ground truth, at first with the samples of side A and then with ever more; or
/// a picture from a file. And what both halves cost and how wrong they are.
class Comparison {
  public:
    /// What may stand there; nothing at all where it has neither technique nor file.
    struct Partner {
        ComparedSide::Kind kind = ComparedSide::Kind::Technique;
        std::unique_ptr<Technique> technique;  ///< the ground truth's as well
        std::optional<int> samplesPerPixel;    ///< where they are not those of side A
        std::optional<FilePicture> file;
    };
    /// As --compare names it; empty for none. Throws UsageError, or Error for a file that can't be read.
    static Partner partnerOf(const std::string& text, const SettingTexts& settings, gl::ProgramCache& programs);

    bool on() const { return partner_.technique || partner_.file; }
    /// Takes it as side B. A partner that is nothing ends the comparison.
    void choose(Partner partner);
    /// Side B's, where that is a technique; null elsewhere.
    Technique* technique() const { return isTechnique() ? partner_.technique.get() : nullptr; }
    ComparedSide::Kind kind() const { return partner_.kind; }
    /// Its own samples per pixel, where it has some; they may be changed and taken away.
    std::optional<int>& ownSamples() { return partner_.samplesPerPixel; }
    /// Exchanges the two, so that the panel's sliders are the other's. Both have to be techniques.
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
    const gl::Texture* picture() const;
    /// Its first row is the uppermost, as in files; OpenGL's own go upwards.
    bool rowsDown() const { return isFile() || truth_.picture() != nullptr; }
    /// Why there is none, though there is a file: its size is another. Empty where all is well.
    const std::string& complaint() const { return complaint_; }
    /// How much wider and higher the picture would have to be.
    std::pair<int, int> missingSize(const FrameRequest& request) const {
        if (!partner_.file) return {0, 0};
        return {partner_.file->width() - request.width, partner_.file->height() - request.height};
    }
    /// The difference of both, once they are whole; null before and in other modes.
    const PictureDifference* difference() const { return difference_ ? &*difference_ : nullptr; }
    /// The ground truth that is found out while nothing changes.
    TruthRefinement& truth() { return truth_; }
    const TruthRefinement& truth() const { return truth_; }
    /// What side B takes, in main memory and on the device.
    std::size_t bytes() const;
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
    /// What the second picture is; null where no technique has drawn one.
    const ShownPicture* shown() const { return driver_ && driver_->picture() != nullptr ? &driver_->shown() : nullptr; }
    const FrameRenderer* renderer() const { return renderer_ ? &*renderer_ : nullptr; }
    /// Both are all that they can be.
    bool settled(const Session& session) const;
    /// Seconds that the window may sleep; nothing if only a change can bring work.
    std::optional<double> sleep(double now) const;

    /// Of the picture that is shown: "TSM, 8 spp, map 1024, shadow error 0.012, 12.3 ms"; what is not known yet is left
    /// out, and a preview has no error: "TSM, 2 spp, map 1024, preview, 45 ms".
    std::string label(const Session& session, bool ofSecond) const;
    /// The two as --compare takes them: "tsm", "ranges:bias=2"; side B also "truth" or a file's path.
    std::vector<std::string> variants(Session& session) const;
    /// Side B so, with all settings of its technique.
    std::string wholeVariant() const;
    /// Both as one picture, as `shot --compare` draws it.
    DisplayImage composedPicture(Session& session);
    LinearImage composedRadiance(Session& session);
    /// Manifests of both, as `shot --compare --json` writes them.
    std::string manifests(Session& session);

    CompareMode mode = CompareMode::Wipe;
    bool flip = false;  ///< instead of the mode: one of them alone, the other while a key is held
    bool flipped = false;
    double seam = 0.5;
    int gain = 4;  ///< of a difference

  private:
    bool isTechnique() const { return partner_.kind == ComparedSide::Kind::Technique; }
    bool isFile() const { return partner_.kind == ComparedSide::Kind::File; }
    bool isTruth() const { return partner_.kind == ComparedSide::Kind::Truth; }
    FrameDriver::Wanted wantedOfSecond(const FrameDriver::Wanted& first) const;
    bool bothWhole(const Session& session) const;
    bool updateFile(const FrameDriver::Wanted& first);
    bool updateStill(Session& session, const FrameDriver::Wanted& first);
    bool updateDifference(Session& session);
    bool updateErrors(Session& session);
    /// Throws Error for one of another size.
    const FilePicture& fittingFile(const FrameRequest& request) const;
    DisplayImage secondImage(const FrameRequest& request);
    LinearImage secondRadiance(const FrameRequest& request);
    std::string second(std::string (*textOf)(Technique&)) const;
    std::string labelOfSecond(int samplesPerPixel) const;

    std::optional<FrameRenderer> renderer_;  ///< made when first needed
    std::optional<FrameDriver> driver_;
    Partner partner_;
    int number_ = 0;  ///< changes with the partner
    TruthRefinement truth_;
    std::optional<gl::Texture> fileTexture_;
    DisplayLook fileLook_;  ///< of that
    std::string complaint_;
    std::optional<PictureDifference> difference_;
    AccuracyProbe probe_;
    std::vector<ProbePoint> points_;
    std::vector<double> pointsOf_;  ///< the moment that they are of, as momentKeyOf
};

/// A technique as --compare takes it, with those of its settings that are not at their defaults.
std::string variantOf(Technique& technique);
/// With all of its settings.
std::string wholeVariantOf(Technique& technique);

/// ":spp=12", as the end of either; empty for those of side A.
std::string ownSamplesText(const std::optional<int>& samples);

}  // namespace timeshade
