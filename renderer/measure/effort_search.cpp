#include "measure/effort_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace timeshade {

namespace {
/// Times vary by about as much from one measurement to the next: an end of the range that comes this near is a find.
constexpr double tolerance = 1.2;
} // namespace

EffortSearch::EffortSearch(std::vector<int> efforts, double target, Value value)
    : efforts_(std::move(efforts)), target_(target), direction_(value), high_(efforts_.size()),
      distance_(std::numeric_limits<double>::infinity()) {}

std::optional<int> EffortSearch::next() const {
    if (outcome_ != Outcome::Searching) return std::nullopt;
    return efforts_[at_];
}

void EffortSearch::answer(double value) {
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
    } else {
        low_ = at_;
        hasLow_ = true;
    }
    if (high_ == efforts_.size()) {
        if (at_ + 1 == efforts_.size()) return end(false);
        const auto doubled = std::lower_bound(efforts_.begin(), efforts_.end(), 2 * efforts_[at_]);
        at_ = std::min(static_cast<std::size_t>(doubled - efforts_.begin()), efforts_.size() - 1);
    } else if (!hasLow_ && high_ == 0) {
        end(false);
    } else if (high_ - low_ <= 1) {
        end(true);
    } else {
        at_ = low_ + (high_ - low_) / 2;
    }
}

void EffortSearch::end(bool reached) {
    const bool near = distance_ <= std::log(tolerance);
    if (reached || near)
        outcome_ = Outcome::Found;
    else
        outcome_ = high_ == 0 ? Outcome::LeastTooMuch : Outcome::MostTooLittle;
}

} // namespace timeshade
