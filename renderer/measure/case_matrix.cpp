#include "measure/case_matrix.h"

#include <algorithm>
#include <cmath>

#include "cases/expectation.h"
#include "core/error.h"

namespace timeshade {

namespace {

using Times = SamplingTraits::Times;

/// Its lit values are the same whatever the seed, but for its stated error.
bool isDeterministic(const ClosedFormCase& c, const TechniqueStatement& stated) {
    // A mean over the shutter is no draw of 0 or 1: what the random times of casters change of it, the stated error
    // bounds.
    if (stated.footprint.time == Footprint::Time::Shutter) return true;
    if (stated.traits.times == Times::RandomInStratum) return false;
    if (stated.traits.times == Times::OneInstant || stated.renders > 1) return true;
    // A mean over a stratum, too, but how many of its samples see the receiver may vary.
    return stated.footprint.time == Footprint::Time::Stratum && c.seenTo - c.seenFrom == 1.0;
}

/// Four standard errors of the mean of independent lit values, one from each stratum at a time.
double samplingTolerance(const ClosedFormCase& c, const TechniqueStatement& stated, const Expectation& e,
                         double valuesPerStratum) {
    if (isDeterministic(c, stated)) return 0.0;
    double variance = 0.0;
    for (const double lit : e.litOfStratum) variance += lit * (1.0 - lit);
    const auto strata = static_cast<double>(e.litOfStratum.size());
    // What an integration's steps pass over, samples may hit.
    if (c.fleeting) variance += strata * c.exact * (1.0 - c.exact);
    variance *= 1.0 / (c.seenTo - c.seenFrom);
    return 4.0 * std::sqrt(variance / (strata * strata * valuesPerStratum));
}

/// As many as bring the noise of one picture down to 0.05; a few more where a picture holds few values.
int picturesFor(const ClosedFormCase& c, const TechniqueStatement& stated, double noiseOfOne, double valuesPerStratum) {
    if (isDeterministic(c, stated)) return 1;
    const int forNoise = static_cast<int>(std::ceil(400.0 * noiseOfOne * noiseOfOne));
    const int forValues = static_cast<int>(std::ceil(100.0 / valuesPerStratum));
    return std::clamp(forNoise, std::min(forValues, 8), 64);
}

}  // namespace

const char* nameOf(Verdict verdict) {
    switch (verdict) {
    case Verdict::Right: return "right";
    case Verdict::Predicted: return "predicted";
    case Verdict::Wrong: return "wrong";
    case Verdict::NotTaken: return "-";
    }
    return "";
}

double measureLitShare(FrameRenderer& renderer, Technique& technique, const ClosedFormCase& c,
                       const CaseSampling& sampleCount, int pictures) {
    FramePlanner planner(*c.scene);
    double lit = 0.0;
    std::size_t samples = 0;
    for (int picture = 0; picture < pictures; ++picture) {
        technique.forget();
        const auto seed = static_cast<std::uint32_t>(picture + 1);
        renderer.begin(planner.plan(c.request(sampleCount.samplesPerPixel, sampleCount.mapSize, seed)), technique,
                       View::Visibility);
        for (bool complete = false; !complete;) {
            complete = renderer.step();
            const std::vector<std::uint32_t> ids = renderer.readSampleIds();
            const std::vector<float> visibility = renderer.readVisibility();
            for (std::size_t i = 0; i < ids.size(); ++i) {
                if (ids[i] < c.firstReceiver || ids[i] >= c.firstReceiver + 2) continue;
                lit += static_cast<double>(visibility[i]);
                ++samples;
            }
        }
    }
    return samples > 0 ? lit / static_cast<double>(samples) : 0.0;
}

CaseResult runCase(FrameRenderer& renderer, Technique& technique, const ClosedFormCase& c,
                   const CaseSampling& sampleCount) {
    CaseResult result;
    result.technique = technique.description().name;
    result.caseName = c.name;
    result.exact = c.exact;
    if (c.kind != ClosedFormCase::Kind::Picture) {
        result.reason =
            c.kind == ClosedFormCase::Kind::Numeric ? "evaluated without a picture" : "about sequences of frames";
        return result;
    }
    FramePlanner planner(*c.scene);
    if (const auto why =
            technique.unsupported(planner.plan(c.request(sampleCount.samplesPerPixel, sampleCount.mapSize, 1)))) {
        result.reason = *why;
        return result;
    }
    const TechniqueStatement stated = statementOf(technique);
    if (const auto why = stated.prediction->fineCastersUnpredicted(); why && c.fleeting) {
        result.reason = *why;
        return result;
    }
    const Expectation e = expectationOf(c, stated, sampleCount.samplesPerPixel, sampleCount.mapSize);
    const double perStratum = independentAnswers(c, stated.traits, sampleCount.mapSize);
    const int pictures = picturesFor(c, stated, samplingTolerance(c, stated, e, perStratum), perStratum);
    try {
        result.value = measureLitShare(renderer, technique, c, sampleCount, pictures);
    } catch (const LimitError& error) {
        result.reason = error.what();
        return result;
    }

    const double noise = samplingTolerance(c, stated, e, perStratum * pictures);
    // Positions that are rounded once, and the patch's own width: its sides are reached by the shadow's ends a little
    // apart.
    double own = stated.traits.statedError + 1e-4 + 0.05 * c.ends * c.patchWidth * (c.fleeting ? 0.0 : 1.0);
    // Half of the time between two renders, for each end.
    if (stated.renders > 1) own += 0.5 * std::min(c.ends, 4) / stated.renders;
    result.tolerance = noise + own + (stated.isOfOneInstant() ? 0.0 : e.resolution);
    result.predicted = e.litShare;
    result.predictedTolerance = noise + e.integration + own;
    result.ties = e.ties;
    if (std::abs(result.error()) <= result.tolerance)
        result.verdict = Verdict::Right;
    else
        result.verdict = result.isAsPredicted() ? Verdict::Predicted : Verdict::Wrong;
    return result;
}

CaseResult runContactGaps(FrameRenderer& renderer, Technique& technique, const CaseSampling& sampleCount) {
    const SamplingTraits traits = technique.samplingTraits();
    CaseResult result;
    result.technique = technique.description().name;
    result.caseName = "smallest_gap";
    result.value = 10.0;
    const double gaps[] = {1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001, 5e-4, 2e-4, 1.5e-4};
    for (const double gap : gaps) {
        const ClosedFormCase c = contactCase(gap);
        FramePlanner planner(*c.scene);
        const FramePlan plan = planner.plan(c.request(sampleCount.samplesPerPixel, sampleCount.mapSize, 1));
        if (const auto why = technique.unsupported(plan)) {
            result.reason = *why;
            return result;
        }
        // A texel's width at the receiver.
        result.predicted =
            traits.texelCentres ? traits.biasTexels * 10.0 * static_cast<double>(plan.block.lightCone.w) : 1e-4;
        if (measureLitShare(renderer, technique, c, sampleCount, 1) > 0.01) break;
        result.value = gap;
    }
    result.tolerance = 0.01;
    result.predictedTolerance = 1.5 * result.predicted + 1e-4;  // the next of the steps
    if (result.value <= result.tolerance)
        result.verdict = Verdict::Right;
    else
        result.verdict =
            result.value <= result.predicted + result.predictedTolerance ? Verdict::Predicted : Verdict::Wrong;
    return result;
}

CaseResult runNumericCase(const ClosedFormCase& c) {
    CaseResult result;
    result.technique = "-";
    result.caseName = c.name;
    result.exact = result.predicted = c.exact;
    result.value = c.evaluate();
    result.tolerance = result.predictedTolerance = 1e-6;
    result.verdict = std::abs(result.error()) <= result.tolerance ? Verdict::Right : Verdict::Wrong;
    return result;
}

}  // namespace timeshade
