#pragma once

#include <deque>
#include <string>
#include <vector>

#include "gl/pass_timer.h"

namespace timeshade {

/// Median times of the last few frames that were drawn alike; of brute force a frame is all its renders together.
/// Empty ("no data") until a frame's times have come.
class FrameTimes {
  public:
    static constexpr std::size_t kept = 15;

    void add(const std::vector<gl::PassTimer::Reading>& readings);
    void reset() { frames_.clear(); }

    std::size_t frames() const { return frames_.size(); }
    /// One a pass, in order of drawing.
    std::vector<gl::PassTimer::Reading> medians() const;
    /// Median of the frames' sums, which is not the sum of the medians.
    double medianTotal() const;
    /// Of the newest frame; 0 where there is none.
    double newestTotal() const { return frames_.empty() ? 0.0 : gl::totalOf(frames_.back()); }

  private:
    std::deque<std::vector<gl::PassTimer::Reading>> frames_;
};

}  // namespace timeshade
