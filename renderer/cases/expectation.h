#pragma once

#include <vector>

#include "cases/closed_form_cases.h"
#include "technique/prediction.h"

namespace timeshade {

/// The mean visibility that a technique computes, predicted in double precision from what it states about itself.
struct Expectation {
    double litShare = 0.0;
    std::vector<double> litOfStratum;  ///< the same, per stratum of the shutter
    /// How much the map's resolution alone may change litShare: half of the time during which a shift of the texel by
    /// half its width changes the result. 0 if casters are thinner than a texel, and for techniques without texels.
    double resolution = 0.0;
    double integration = 0.0;  ///< error bound of the numerical integration in litShare
    /// How much less is lit where all that is as far from the light as the receiver shadows it. Without a bias,
    /// rounding decides such ties: a technique is held to litShare - ties .. litShare. 0 with a bias.
    double ties = 0.0;
};

/// `c` must be of kind Picture.
Expectation expectationOf(const ClosedFormCase& c, const TechniqueStatement& stated, int samplesPerPixel,
                          const MapSize& mapSize);

/// The number of independent samples of visibility in one stratum of one picture: texels of the map that the picture's
/// column covers or, for techniques without texels, camera samples.
double independentAnswers(const ClosedFormCase& c, const SamplingTraits& traits, const MapSize& mapSize);

}  // namespace timeshade
