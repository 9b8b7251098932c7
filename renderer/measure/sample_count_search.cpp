#include "measure/sample_count_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace timeshade {

namespace {
/// Times vary by about as much from one measurement to the next: an end of the range that comes this near is a find.
constexpr double tolerance = 1.2;
}  // namespace

SampleCountSearch::SampleCountSearch(std::vector<int> sampleCounts, double target, Value value)
    : sampleCounts_(std::move(sampleCounts)),
      target_(target),
      direction_(value),
      high_(sampleCounts_.size()),
      distance_(std::numeric_limits<double>::infinity()) {}

std::optional<int> SampleCountSearch::next() const {
    if (outcome_ != Outcome::Searching) return std::nullopt;
    return sampleCounts_[at_];
}

void SampleCountSearch::measured(double value) {
    // Both axes of the chart are logarithmic, and so is what counts as near. No error at all is infinitely far.
    const double distance = std::abs(std::log(value / target_));
    if (distance < distance_ || value_ == 0.0) {
        nearest_ = at_;
        value_ = value;
        distance_ = distance;
    }
    const bool passes = direction_ == Value::Rises ? value >= target_ : value <= target_;
    if (passes) {
        high_ = at_;
        highValue_ = value;
    } else {
        low_ = at_;
        lowValue_ = value;
        hasLow_ = true;
    }
    if (high_ == sampleCounts_.size()) {
        if (at_ + 1 == sampleCounts_.size()) return end(false);
        const auto doubled = std::lower_bound(sampleCounts_.begin(), sampleCounts_.end(), 2 * sampleCounts_[at_]);
        at_ = std::min(static_cast<std::size_t>(doubled - sampleCounts_.begin()), sampleCounts_.size() - 1);
    } else if (!hasLow_ && high_ == 0) {
        end(false);
    } else if (high_ - low_ <= 1) {
        end(true);
    } else {
        at_ = low_ + (high_ - low_) / 2;
    }
}

std::optional<SampleCountSearch::Measured> SampleCountSearch::shortOfTarget() const {
    if (!hasLow_) return std::nullopt;
    return Measured{sampleCounts_[low_], lowValue_};
}

std::optional<SampleCountSearch::Measured> SampleCountSearch::pastTarget() const {
    if (high_ == sampleCounts_.size()) return std::nullopt;
    return Measured{sampleCounts_[high_], highValue_};
}

void SampleCountSearch::end(bool reached) {
    const bool near = distance_ <= std::log(tolerance);
    if (reached || near)
        outcome_ = Outcome::Found;
    else
        outcome_ = high_ == 0 ? Outcome::LeastTooMuch : Outcome::MostTooLittle;
}

}  // namespace timeshade
