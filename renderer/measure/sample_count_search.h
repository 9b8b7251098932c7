#pragma once

#include <optional>
#include <vector>

namespace timeshade {

/// Finds the sample count (samples per pixel, or renders) whose measured value comes nearest to a target, in few
/// measurements: doubling until the target is passed, then bisection. Knows nothing of what is measured.
class SampleCountSearch {
  public:
    /// What more samples do to the value: time rises, error falls.
    enum class Value { Rises, Falls };

    /// `sampleCounts` in ascending order, not empty; the target is above 0.
    SampleCountSearch(std::vector<int> sampleCounts, double target, Value value);

    /// The sample count to be measured next; nothing when the search has ended.
    std::optional<int> next() const;
    /// The value of next().
    void measured(double value);

    enum class Outcome {
        Searching,
        Found,          ///< see sampleCount()
        LeastTooMuch,   ///< even the fewest samples lie beyond the target
        MostTooLittle,  ///< even the most samples do not reach it
    };
    Outcome outcome() const { return outcome_; }
    /// The sample count that came nearest and its value; whatever the outcome, once the search has ended.
    int sampleCount() const { return sampleCounts_[nearest_]; }
    double value() const { return value_; }

    struct Measured {
        int sampleCount = 0;
        double value = 0.0;
    };
    /// The neighbours between which the target lies, once the search has ended: the most samples that stay short of it,
    /// nothing where even the fewest pass it; and the fewest that pass or meet it, nothing where even the most don't.
    std::optional<Measured> shortOfTarget() const;
    std::optional<Measured> pastTarget() const;

  private:
    void end(bool reached);

    std::vector<int> sampleCounts_;
    double target_;
    Value direction_;
    std::size_t at_ = 0;   ///< being measured
    std::size_t low_ = 0;  ///< the largest that stays short of the target; meaningless before there is one
    bool hasLow_ = false;
    std::size_t high_;  ///< the smallest that passes it, sampleCounts_.size() while none does
    double lowValue_ = 0.0, highValue_ = 0.0;
    std::size_t nearest_ = 0;
    double value_ = 0.0, distance_;
    Outcome outcome_ = Outcome::Searching;
};

}  // namespace timeshade
