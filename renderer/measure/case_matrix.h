#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/closed_form_cases.h"
#include "frame/frame_renderer.h"

namespace timeshade {

/// How a technique's lit share of an analytic case compares with the exact one.
enum class Verdict {
    Right,      ///< exact within the tolerance that follows from what the technique states about itself
    Predicted,  ///< off, by as much as that says
    Wrong,      ///< neither
    NotTaken,   ///< the technique does not support the case, or the case is no picture
};
const char* nameOf(Verdict verdict);

/// One cell of the matrix.
struct CaseResult {
    std::string technique;  ///< "-" for a numeric case
    std::string caseName;
    double exact = 0.0;
    double value = 0.0;      ///< mean lit of the samples that see the receiver
    double tolerance = 0.0;  ///< about exact
    double predicted = 0.0;  ///< what follows from the technique's statement
    double predictedTolerance = 0.0;
    double ties = 0.0;  ///< how much less is predicted where ties of depth cast shadows (Expectation::ties)
    Verdict verdict = Verdict::NotTaken;
    std::string reason;  ///< why it is not taken, in words

    double error() const { return value - exact; }
    bool isAsPredicted() const {
        return value <= predicted + predictedTolerance && value >= predicted - ties - predictedTolerance;
    }
};

struct CaseSampling {
    int samplesPerPixel = 8;
    MapSize mapSize = 512;
};

/// Mean lit, over the samples that see the case's receiver, of `pictures` pictures with seeds from 1.
double measureLitShare(FrameRenderer& renderer, Technique& technique, const ClosedFormCase& c,
                       const CaseSampling& sampleCount, int pictures);

/// Draws the case with the technique as it is set and judges it. As many pictures are drawn as leave no more noise than
/// 0.05 (four standard errors).
CaseResult runCase(FrameRenderer& renderer, Technique& technique, const ClosedFormCase& c,
                   const CaseSampling& sampleCount);

/// The smallest gap between a caster and its receiver, in steps of 1, 2, 5, at which the shadow is there (lit at most 1
/// %), all wider ones included; the light is 10 away. As a cell: right down to a thousandth of that distance, predicted
/// down to the technique's own bias.
CaseResult runContactGaps(FrameRenderer& renderer, Technique& technique, const CaseSampling& sampleCount);

/// A case without a technique: a shared function at floats.
CaseResult runNumericCase(const ClosedFormCase& c);

}  // namespace timeshade
