#include "measure/verification.h"

#include <utility>

#include "shared/hash.shared.h"
#include "shared/shutter_response.shared.h"

namespace timeshade {

namespace {

std::size_t pixelCount(const FramePlan& plan) { return std::size_t{plan.block.imageSize.x} * plan.block.imageSize.y; }

/// Of interval samples, which have no instant to compare at: what makes a pixel's mean.
void addParts(const FrameRenderer& renderer, const FramePlan& plan, Verification& sum, PixelMeans& pixels) {
    const auto exposureUntil = [&](float u) {
        return static_cast<double>(shared::shutterExposure(plan.block.response, plan.block.responseWidth, u));
    };
    sum.intervals = true;
    for (const FrameRenderer::PartValue& value : renderer.readParts()) {
        ++sum.samples;
        if (value.tested <= 0.0f) continue;
        ++sum.tested;
        const double exposure = exposureUntil(value.part.end) - exposureUntil(value.part.begin);
        pixels.add(value.part.place / plan.block.positions, static_cast<double>(value.lit),
                   exposure * static_cast<double>(value.tested));
    }
}

/// Walks the samples of one render, whose buffers are in the renderer.
class RenderComparison {
  public:
    RenderComparison(const Oracle& oracle, const FramePlan& plan, const VerificationOptions& options, Verification& sum,
                     FootprintErrorSum& footprintError, PixelMeans& pixels)
        : oracle_(oracle),
          plan_(plan),
          options_(options),
          sum_(sum),
          footprintError_(footprintError),
          pixels_(pixels) {}

    void compareLit(const std::vector<std::uint32_t>& triangles, const std::vector<float>& lit, int stratumShown) {
        const std::vector<OracleAnswer> answers = oracle_.answer(plan_, triangles);
        for (std::size_t i = 0; i < answers.size(); ++i) {
            ++sum_.samples;
            if (!answers[i].hit) continue;
            const SampleIndex index = indexOf(i);
            const OracleAnswer truth = answers[i].tested ? decide(answers[i], index, triangles[i], lit[i]) : answers[i];
            if (truth.tested) {
                count(truth, lit[i]);
                footprintError_.add(index, triangles[i], truth, lit[i]);
                pixels_.add(i % pixelCount(plan_), static_cast<double>(lit[i]), weightOf(truth));
            }
            if (options_.visit) {
                const std::uint32_t first = plan_.block.firstStratum + static_cast<std::uint32_t>(stratumShown);
                options_.visit({{index.x, index.y, index.stratum + first}, triangles[i], truth, lit[i]});
            }
        }
    }

    void comparePrimaries(const std::vector<std::uint32_t>& triangles) {
        const std::vector<std::uint32_t> traced = oracle_.tracePrimaries(plan_);
        sum_.primaryTested += triangles.size();
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            if (traced[i] == triangles[i]) continue;
            const Oracle::ResolvedPrimary resolved = oracle_.resolvePrimary(plan_, indexOf(i));
            if (resolved.triangle == triangles[i]) continue;
            ++(resolved.marginal ? sum_.primaryMarginal : sum_.primaryDisagree);
        }
    }

  private:
    double weightOf(const OracleAnswer& truth) const {
        return static_cast<double>(shared::shutterWeight(plan_.block.response, plan_.block.responseWidth, truth.time));
    }

    SampleIndex indexOf(std::size_t i) const {
        const auto width = static_cast<std::size_t>(plan_.request.width),
                   height = static_cast<std::size_t>(plan_.request.height);
        return {static_cast<std::uint32_t>(i % width), static_cast<std::uint32_t>(i / width % height),
                static_cast<std::uint32_t>(i / (width * height))};
    }

    OracleAnswer decide(const OracleAnswer& embree, SampleIndex index, std::uint32_t triangle, float lit) {
        const bool agrees = (lit >= 0.5f) == embree.lit;
        const std::uint32_t lot = shared::hashWords({index.x, index.y, index.stratum}).x;
        if (agrees && lot % options_.resolvedShare != 0) return embree;
        const OracleAnswer resolved = oracle_.resolve(plan_, index, triangle);
        ++sum_.resolvedExactly;
        if (resolved.lit != embree.lit) ++sum_.corrected;
        return resolved;
    }

    void count(const OracleAnswer& truth, float lit) {
        ++sum_.tested;
        if (!truth.lit) ++sum_.shadowed;
        sum_.meanAbsoluteError += std::abs(static_cast<double>(lit) - (truth.lit ? 1.0 : 0.0));
        const bool seemsLit = lit >= 0.5f;
        if (seemsLit == truth.lit) return;
        ++(seemsLit ? sum_.falseLit : sum_.falseShadow);
        if (truth.marginal) ++sum_.marginal;
    }

    const Oracle& oracle_;
    const FramePlan& plan_;
    const VerificationOptions& options_;
    Verification& sum_;
    FootprintErrorSum& footprintError_;
    PixelMeans& pixels_;
};

}  // namespace

FrameVerification::FrameVerification(FrameRenderer& renderer, FramePlan plan, Technique& technique,
                                     VerificationOptions options)
    : renderer_(renderer),
      plan_(std::move(plan)),
      options_(std::move(options)),
      instants_(technique.renders()),
      footprintError_(plan_, instants_, technique.footprint(), options_.footprint),
      pixels_(pixelCount(plan_)) {
    sum_.footprint = technique.footprint();
    renderer_.begin(plan_, technique, View::Visibility);
}

bool FrameVerification::step() {
    if (done_ == renders()) return true;
    renderer_.step();
    if (plan_.block.positions > 0) {
        addParts(renderer_, plan_, sum_, pixels_);
        return ++done_ == renders();
    }
    const FramePlan drawn = renderOf(plan_, done_, instants_);
    const Oracle& oracle = oracle_.of(drawn);
    const std::vector<std::uint32_t> triangles = renderer_.readSampleIds();
    RenderComparison comparison(oracle, drawn, options_, sum_, footprintError_, pixels_);
    footprintError_.beginRender(oracle, drawn, done_);
    comparison.compareLit(triangles, renderer_.readVisibility(), instants_ > 1 ? done_ : 0);
    footprintError_.finishRender();
    if (options_.checkPrimaries) comparison.comparePrimaries(triangles);
    ++done_;
    if (options_.progress) options_.progress(done_, renders());
    return done_ == renders();
}

Verification FrameVerification::result() const {
    Verification verification = sum_;
    if (sum_.tested > 0) verification.meanAbsoluteError /= static_cast<double>(sum_.tested);
    verification.footprintError = footprintError_.result();
    if (options_.reference && done_ == renders()) verification.shadowError = pixels_.against(*options_.reference);
    return verification;
}

Verification verifyFrame(FrameRenderer& renderer, const FramePlan& plan, Technique& technique,
                         const VerificationOptions& options) {
    FrameVerification verification(renderer, plan, technique, options);
    while (!verification.step()) {
    }
    return verification.result();
}

}  // namespace timeshade
