#include "measure/footprint_error.h"

#include <algorithm>

#include "shared/hash.shared.h"

namespace timeshade {

namespace {

std::size_t pixelsOf(const FramePlan& plan) { return std::size_t{plan.block.imageSize.x} * plan.block.imageSize.y; }

}  // namespace

FootprintErrorSum::FootprintErrorSum(const Oracle& oracle, const FramePlan& plan, int renders,
                                     const Footprint& footprint, Options options)
    : oracle_(oracle),
      footprint_(footprint),
      options_(options),
      strata_(renders > 1 ? static_cast<std::uint32_t>(renders) : plan.block.strata),
      width_(plan.block.imageSize.x),
      sum_(pixelsOf(plan)) {
    chosenShare_ = static_cast<double>(options.samples) / (static_cast<double>(pixelsOf(plan)) * strata_);
}

void FootprintErrorSum::beginRender(const FramePlan& plan, int render) {
    plan_ = &plan;
    render_ = static_cast<std::uint32_t>(render);
}

/// A filter is no part of the truth.
bool FootprintErrorSum::isExact() const {
    return footprint_.time == Footprint::Time::Instant && footprint_.space == Footprint::Space::Point;
}

bool FootprintErrorSum::isChosen(SampleIndex sample) const {
    const std::uint32_t lot = shared::hashWords({sample.x, sample.y, 0x5eedu + sample.stratum + render_}).y;
    return static_cast<double>(shared::unitInterval(lot)) < chosenShare_;
}

SampleFootprint FootprintErrorSum::over(SampleIndex sample, std::uint32_t triangle, float time) const {
    SampleFootprint over{sample, triangle, 0.0f, 1.0f, SampleFootprint::Space::Point};
    if (footprint_.space == Footprint::Space::PixelSurface) over.space = SampleFootprint::Space::PixelSurface;
    if (footprint_.time == Footprint::Time::Instant) over.from = over.to = time;
    if (footprint_.time == Footprint::Time::Stratum) {
        // Renders at one instant each share the shutter as strata do.
        const auto stratum = static_cast<float>(sample.stratum + render_);
        over.from = stratum / static_cast<float>(strata_);
        over.to = std::min(1.0f, (stratum + 1.0f) / static_cast<float>(strata_));
    }
    return over;
}

std::size_t FootprintErrorSum::pixelOf(SampleIndex sample) const { return sample.y * width_ + sample.x; }

void FootprintErrorSum::add(SampleIndex sample, std::uint32_t triangle, const OracleAnswer& truth, float lit) {
    if (isExact()) {
        const double less = static_cast<double>(lit) - (truth.lit ? 1.0 : 0.0);
        sum_.add(pixelOf(sample), less, less);
    } else if (isChosen(sample)) {
        chosen_.push_back(over(sample, triangle, truth.time));
        lit_.push_back(lit);
    }
}

void FootprintErrorSum::finishRender() {
    if (chosen_.empty()) return;
    const std::uint32_t half = std::max(1u, options_.rays / 2);
    const std::vector<VisibilityMean> first = oracle_.footprintMeans(*plan_, chosen_, half, firstSeed);
    const std::vector<VisibilityMean> second = oracle_.footprintMeans(*plan_, chosen_, half, secondSeed);
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
        if (!first[i].exists() || !second[i].exists()) continue;
        const double lit = static_cast<double>(lit_[i]);
        sum_.add(pixelOf(chosen_[i].sample), lit - first[i].value(), lit - second[i].value());
    }
    chosen_.clear();
    lit_.clear();
}

FootprintError FootprintErrorSum::result() const {
    return {sum_.summary(), isExact() ? 0u : 2 * std::max(1u, options_.rays / 2)};
}

}  // namespace timeshade
