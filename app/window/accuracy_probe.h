#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame/frame_renderer.h"
#include "measure/piece_oracle.h"
#include "measure/reference.h"
#include "measure/reference_visibility.h"
#include "measure/shadow_error.h"

namespace timeshade {

/// A technique as it is set, and what it is given to work with.
struct ProbeSubject {
    std::string technique;
    std::vector<double> settings;  ///< in the order of settingsOf
    int samplesPerPixel = 8;
    MapSize mapSize;
    bool operator==(const ProbeSubject&) const = default;
};

/// What one subject costs and how far it is from the reference, both at the probe's size.
struct ProbePoint {
    ProbeSubject subject;
    double milliseconds = 0.0;       ///< median of the draws that count
    double shadowError = 0.0;        ///< RMS, with the reference's own noise removed; what "equal error" means
    std::optional<double> wrongPpm;  ///< wrong shadow samples in a million, where each value is a single test
    double rmse = 0.0;               ///< of the image
};

/// "shadow error 0.0147": what techniques of any kind can be compared by.
std::string errorInWords(const ProbePoint& point);

/// The subject's technique, set as it says.
std::unique_ptr<Technique> techniqueOf(const ProbeSubject& subject, gl::ProgramCache& programs);
/// The same frame with sides of at most so many pixels, of the same shape.
FrameRequest smallCopyOf(const FrameRequest& request, int longestSide);
/// All that a small copy depends on but the subject.
std::vector<double> smallCopyKey(const FrameRequest& small, int scene);

/// Measures techniques on a small copy of the window's frame, with a renderer of its own so that the picture stays as
/// it is. Works a step at a time: some rows of the converged visibility, a batch of the reference image, or a draw of
/// the technique.
class AccuracyProbe {
  public:
    static constexpr int longestSide = 240;
    static constexpr int referenceSamples = 64;  ///< per pixel, of the reference image
    static constexpr int referenceRays = 256;    ///< per pixel, of the converged visibility

    /// Says which frame is meant. True if it is another than before, or of another shape: the reference is then made
    /// anew and earlier points do not compare. The planner is that of the scene with this number.
    bool aim(FramePlanner& planner, int scene, const FrameRequest& request);
    /// Says what is to be measured; starts over if that is another subject than before.
    void measure(const ProbeSubject& subject);
    /// Does the next step. The point, when this step has completed it.
    std::optional<ProbePoint> step();
    /// Why the subject can't be measured; empty if it can.
    const std::string& failure() const { return failure_; }

    int width() const { return request_.width; }
    int height() const { return request_.height; }
    /// Both references are there.
    bool hasReferences() const { return reference_ && reference_->complete(); }
    /// Share of the work on both that is done.
    double referenceProgress() const;

  private:
    std::optional<ProbePoint> draw();
    void beginSubject();
    void compareRender();
    FramePlan planFor(int samplesPerPixel, const MapSize& mapSize);

    std::optional<FrameRenderer> renderer_;  ///< made when first needed
    ReferenceCache cache_;
    FramePlanner* planner_ = nullptr;
    FrameRequest request_;
    std::vector<double> key_;  ///< of the frame
    std::unique_ptr<ReferenceVisibilityBuilder> visibility_;
    std::unique_ptr<ReferenceBuilder> reference_;  ///< once there is the visibility

    std::optional<ProbeSubject> subject_;
    std::unique_ptr<Technique> technique_;
    std::optional<FramePlan> plan_;
    bool drawing_ = false;
    double milliseconds_ = 0.0;  ///< of the draw at work
    std::vector<double> times_;  ///< of the completed draws
    LinearImage image_;          ///< of the first of them

    PieceOracle oracle_;
    std::optional<PixelMeans> means_;
    std::uint64_t tested_ = 0, wrong_ = 0;
    std::string failure_;
};

}  // namespace timeshade
