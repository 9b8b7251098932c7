#pragma once

#include <cstdint>
#include <vector>

#include "measure/error_summary.h"
#include "oracle/oracle.h"
#include "technique/footprint.h"

namespace timeshade {

/// How far `lit` at a technique's own samples is from the oracle's mean over the technique's own footprint: what the
/// technique itself gets wrong, whatever its number of samples.
struct FootprintError {
    ErrorSummary error;      ///< its count is that of the samples that were compared
    std::uint32_t rays = 0;  ///< of each mean, both halves together; 0 where the truth is exact
};

/// The domain of the true mean for a technique's value at a sample, which sees this triangle at this time, in the
/// stratum of that number of so many.
SampleFootprint footprintOf(const Footprint& footprint, SampleIndex sample, std::uint32_t triangle, float time,
                            std::uint32_t stratum, std::uint32_t strata);

/// Collects the samples of all renders of a frame. Where the footprint is an instant at a point, the truth is the
/// oracle's exact value and every tested sample is compared. Else the truth is a mean of rays, in two independent
/// halves, and samples are chosen by a hash of their place. A declared blur is no part of the truth.
class FootprintErrorSum {
  public:
    /// Of the rays of the two halves.
    static constexpr std::uint32_t firstSeed = 0x0f007001u, secondSeed = 0x0f008002u;

    struct Options {
        std::uint32_t samples = 16384;  ///< about so many of all camera samples are compared where that takes means
        std::uint32_t rays = 512;       ///< of each mean, both halves together
    };

    /// `plan` is that of the whole frame, of which the technique draws so many instants, or 1.
    FootprintErrorSum(const FramePlan& plan, int instants, const Footprint& footprint, Options options);
    /// The render that the samples after this belong to: its oracle, its plan, and its number. Both must live until
    /// finishRender.
    void beginRender(const Oracle& oracle, const FramePlan& plan, int render);
    /// A sample that faces the light inside its cone.
    void add(SampleIndex sample, std::uint32_t triangle, const OracleAnswer& truth, float lit);
    void finishRender();
    FootprintError result() const;

  private:
    bool isChosen(SampleIndex sample) const;
    std::size_t pixelOf(SampleIndex sample) const;

    Footprint footprint_;
    Options options_;
    const Oracle* oracle_ = nullptr;
    const FramePlan* plan_ = nullptr;
    std::uint32_t render_ = 0, instants_ = 1;
    double chosenShare_ = 1.0;
    std::size_t width_ = 0;
    std::vector<SampleFootprint> chosen_;
    std::vector<float> lit_;
    ErrorSum sum_;
};

}  // namespace timeshade
