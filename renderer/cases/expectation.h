#pragma once

#include <vector>

#include "cases/closed_form_cases.h"
#include "technique/sampling_traits.h"

namespace timeshade {

/// What a technique with the given traits answers in the mean, from the traits alone, in double precision.
struct Expectation {
    double litShare = 0.0;
    std::vector<double> litOfStratum;  ///< the same for each stratum of the shutter
    /// By how much the map's resolution alone may move the share: half of the time during which half a texel to some
    /// side decides. 0 where casters are thinner than a texel, and for techniques without texels.
    double resolution = 0.0;
    double integration = 0.0;  ///< how far litShare may be from the mean that it stands for
};

/// Needs a case with a picture.
Expectation expectationOf(const ClosedFormCase& c, const SamplingTraits& traits, int samplesPerPixel, int mapSize);

/// How many independent answers one stratum of one picture holds: texels of the map that the picture's column covers,
/// or, where a technique has no texels, camera samples.
double independentAnswers(const ClosedFormCase& c, const SamplingTraits& traits, int mapSize);

}  // namespace timeshade
