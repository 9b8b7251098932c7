#include "measure/footprint_error.h"

#include <algorithm>

#include "shared/hash.shared.h"

namespace timeshade {

namespace {

std::size_t pixelsOf(const FramePlan& plan) { return std::size_t{plan.block.imageSize.x} * plan.block.imageSize.y; }

}  // namespace

SampleFootprint footprintOf(const Footprint& footprint, SampleIndex sample, std::uint32_t triangle, float time,
                            std::uint32_t stratum, std::uint32_t strata) {
    SampleFootprint over{sample, triangle, 0.0f, 1.0f, SampleFootprint::Space::Point};
    if (footprint.space == Footprint::Space::PixelSurface) over.space = SampleFootprint::Space::PixelSurface;
    if (footprint.time == Footprint::Time::Instant) over.from = over.to = time;
    if (footprint.time == Footprint::Time::Stratum) {
        over.from = static_cast<float>(stratum) / static_cast<float>(strata);
        over.to = std::min(1.0f, static_cast<float>(stratum + 1) / static_cast<float>(strata));
    }
    return over;
}

FootprintErrorSum::FootprintErrorSum(const FramePlan& plan, int instants, const Footprint& footprint, Options options)
    : footprint_(footprint),
      options_(options),
      instants_(static_cast<std::uint32_t>(instants)),
      width_(plan.block.imageSize.x),
      sum_(pixelsOf(plan)) {
    const std::uint32_t strata = instants > 1 ? instants_ : plan.block.strata;
    chosenShare_ = static_cast<double>(options.samples) / (static_cast<double>(pixelsOf(plan)) * strata);
}

void FootprintErrorSum::beginRender(const Oracle& oracle, const FramePlan& plan, int render) {
    oracle_ = &oracle;
    plan_ = &plan;
    render_ = static_cast<std::uint32_t>(render);
}

bool FootprintErrorSum::isChosen(SampleIndex sample) const {
    const std::uint32_t lot = shared::hashWords({sample.x, sample.y, 0x5eedu + sample.stratum + render_}).y;
    return static_cast<double>(shared::unitInterval(lot)) < chosenShare_;
}

std::size_t FootprintErrorSum::pixelOf(SampleIndex sample) const { return sample.y * width_ + sample.x; }

void FootprintErrorSum::add(SampleIndex sample, std::uint32_t triangle, const OracleAnswer& truth, float lit) {
    if (footprint_.isInstantAtPoint()) {
        const double less = static_cast<double>(lit) - (truth.lit ? 1.0 : 0.0);
        sum_.add(pixelOf(sample), less, less);
    } else if (isChosen(sample)) {
        // Renders at one instant each share the shutter as strata do.
        const bool isInstant = instants_ > 1;
        chosen_.push_back(footprintOf(footprint_, sample, triangle, truth.time, isInstant ? render_ : sample.stratum,
                                      isInstant ? instants_ : plan_->block.strata));
        lit_.push_back(lit);
    }
}

void FootprintErrorSum::finishRender() {
    if (chosen_.empty()) return;
    const std::uint32_t half = std::max(1u, options_.rays / 2);
    const std::vector<VisibilityMean> first = oracle_->footprintMeans(*plan_, chosen_, half, firstSeed);
    const std::vector<VisibilityMean> second = oracle_->footprintMeans(*plan_, chosen_, half, secondSeed);
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
        if (!first[i].exists() || !second[i].exists()) continue;
        const double lit = static_cast<double>(lit_[i]);
        sum_.add(pixelOf(chosen_[i].sample), lit - first[i].value(), lit - second[i].value());
    }
    chosen_.clear();
    lit_.clear();
}

FootprintError FootprintErrorSum::result() const {
    return {sum_.summary(), footprint_.isInstantAtPoint() ? 0u : 2 * std::max(1u, options_.rays / 2)};
}

}  // namespace timeshade
