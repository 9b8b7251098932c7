#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace timeshade::gl {

/// How much of some work to do before it may pause: about 15 ms, by what the last piece took. What the device has been
/// told must be done (glFinish) before a piece begins and where it ends.
class PieceLength {
  public:
    PieceLength(std::size_t first, std::size_t most) : length_(std::min(first, most)), most_(most) {}

    /// The piece begins.
    std::size_t next() {
        begin_ = Clock::now();
        return length_;
    }
    void wasDone() {
        const double taken = std::chrono::duration<double, std::milli>(Clock::now() - begin_).count();
        const double factor = std::min(wanted / std::max(taken, 1e-3), growth);
        length_ = std::clamp(static_cast<std::size_t>(static_cast<double>(length_) * factor), std::size_t{1}, most_);
    }

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr double wanted = 15.0;  // milliseconds
    static constexpr double growth = 4.0;   // at most, from one to the next

    std::size_t length_, most_;
    Clock::time_point begin_;
};

}  // namespace timeshade::gl
