#pragma once

#include "technique/candidate_lists.h"
#include "technique/technique.h"
#include "technique/view_target.h"

namespace timeshade {

/// The mean of visibility over a stratum, or over the shutter, by integration instead of samples (ours;
/// docs/numerics.md, "Integrals over time"): of the candidates of every cell and bucket that the receiver passes
/// through during the stratum, the times at which each shadows it are found between the roots of polynomials in time,
/// and the value is 1 less the length of their union, over the times at which the receiver faces the light inside its
/// cone. Weighted by the shutter's response. No noise in time, no time mismatch, no bias, no aliasing; what is left is
/// where in a pixel its samples lie. Error: about 1e-7 of the stratum an end of a shadow, more where a shadow's edge
/// hardly moves (the view `error-bound`).
///
/// The polynomials have the degree that the frame's motion calls for: 0 where nothing moves, 1 where only the light
/// does, 2 (edges) under a directional light that does not turn, else 3.
class IntegralShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit IntegralShadow(gl::ProgramCache& programs) : programs_(programs), lists_(programs) {
        resetSettings(*this);
    }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    Footprint footprint() const override;
    SamplingTraits samplingTraits() const override;
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    void build(const TechniqueFrame& frame) override { lists_.build(frame); }
    bool solvesIntervals() const override { return true; }
    LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) override;
    /// A union of casters is no product: what static ones do says nothing about all.
    bool separatesStaticCasters() const override { return false; }
    std::vector<TechniqueView> views() const override;
    void drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) override;
    StoredAlongLine storedAlong(const TechniqueFrame& frame, const MapLine& line) override;
    std::vector<TechniqueStatistic> statistics() const override { return lists_.statistics(); }
    std::size_t bytes() const override { return lists_.bytes(); }

  private:
    gl::ProgramCache& programs_;
    int over_{};  ///< 0: a stratum, 1: the shutter
    CandidateLists lists_;
    ViewTarget viewTarget_;
};

}  // namespace timeshade
