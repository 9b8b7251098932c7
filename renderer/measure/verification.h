#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "frame/frame_renderer.h"
#include "measure/footprint_error.h"
#include "measure/piece_oracle.h"
#include "measure/shadow_error.h"

namespace timeshade {

/// How a technique's lit values for the camera samples of one frame compare with the oracle's. Counts take a value for
/// lit from 1/2 on, and compare it at the sample's own instant and point: they say something of techniques whose
/// footprint is binary. The two errors say something of all.
struct Verification {
    std::uint64_t samples = 0;          ///< camera samples of the frame
    std::uint64_t tested = 0;           ///< of those: see a surface that faces the light inside its cone
    std::uint64_t shadowed = 0;         ///< of the tested: truly in shadow
    std::uint64_t falseShadow = 0;      ///< lit in truth, shadowed by the technique (lit < 1/2)
    std::uint64_t falseLit = 0;         ///< shadowed in truth, lit by the technique
    std::uint64_t marginal = 0;         ///< of the two above: within 1e-6 of an edge or end, where rounding decides
    std::uint64_t resolvedExactly = 0;  ///< decided in double precision: all disagreements, a share of the rest
    std::uint64_t corrected = 0;        ///< of those: Embree was wrong
    std::uint64_t primaryTested = 0;    ///< camera samples whose triangle was compared
    std::uint64_t primaryDisagree = 0;  ///< the sample pass saw another triangle than the oracle, exactly resolved
    std::uint64_t primaryMarginal =
        0;                           ///< differences within 1e-6 of an edge or of equal depth; not in primaryDisagree
    double meanAbsoluteError = 0.0;  ///< mean over the tested of |lit - truth at the sample's own instant and point|

    /// Camera samples were intervals: `samples` counts their parts, `tested` those that face the light inside its cone
    /// for some time, and of all the rest only the shadow error is measured.
    bool intervals = false;
    Footprint footprint;                     ///< of the technique, with its settings as they were
    FootprintError footprintError;           ///< count 0 where it was not measured
    std::optional<ShadowError> shadowError;  ///< where a reference was given, once all renders have been compared

    /// Each sample is right or wrong.
    bool isBinary() const { return !intervals && footprint.isBinary(); }
    std::uint64_t disagree() const { return falseShadow + falseLit; }
    double ppm() const {
        return tested == 0 ? 0.0 : 1e6 * static_cast<double>(disagree()) / static_cast<double>(tested);
    }
    double primaryPpm() const {
        return primaryTested == 0 ? 0.0
                                  : 1e6 * static_cast<double>(primaryDisagree) / static_cast<double>(primaryTested);
    }
};

/// One camera sample as the dump and the views show it.
struct VerifiedSample {
    SampleIndex index;  ///< its stratum is that of the whole shutter
    std::uint32_t triangle = NO_TRIANGLE;
    OracleAnswer truth;  ///< its time is that in its piece of the shutter
    float lit = 1.0f;    ///< the technique's value
};

struct VerificationOptions {
    /// One agreeing sample in so many is resolved exactly too, chosen by a hash of its place.
    std::uint32_t resolvedShare = 64;
    bool checkPrimaries = true;
    /// What the shadow error is measured against: the converged visibility of the same frame. None: no shadow error.
    std::shared_ptr<const ReferenceVisibility> reference;
    /// How many samples the footprint error is measured on, and how well, where its truth is not exact. No samples: no
    /// such error then.
    FootprintErrorSum::Options footprint;
    /// Called with every sample that sees something, in order, if set.
    std::function<void(const VerifiedSample&)> visit;
    /// Called after each render with how many of how many are done, if set.
    std::function<void(int, int)> progress;
};

/// Draws the frame and compares every camera sample of it: `lit` with the oracle's truth, and the triangle seen with
/// the oracle's primary ray. Wherever technique and Embree disagree, the sample is resolved exactly. One render a
/// step, so that a window stays alive; nobody else may draw with this renderer in between.
class FrameVerification {
  public:
    /// The technique must outlive it.
    FrameVerification(FrameRenderer& renderer, FramePlan plan, Technique& technique, VerificationOptions options);
    /// True when all renders have been compared.
    bool step();
    int rendersDone() const { return done_; }
    int renders() const { return renderer_.renders(); }
    /// Of what has been compared so far.
    Verification result() const;

  private:
    FrameRenderer& renderer_;
    FramePlan plan_;
    VerificationOptions options_;
    int instants_;  ///< that the technique draws of the frame
    PieceOracle oracle_;
    Verification sum_;
    FootprintErrorSum footprintError_;
    PixelMeans pixels_;
    int done_ = 0;
};

/// The same in one go.
Verification verifyFrame(FrameRenderer& renderer, const FramePlan& plan, Technique& technique,
                         const VerificationOptions& options);

}  // namespace timeshade
