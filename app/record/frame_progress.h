#pragma once

#include <chrono>
#include <string>

namespace timeshade {

/// "frame 12 of 120, 0:34 left" on standard error where that is a terminal: one line that is written over and wiped at
/// the end.
class FrameProgress {
  public:
    explicit FrameProgress(int frames);
    ~FrameProgress();
    FrameProgress(const FrameProgress&) = delete;
    FrameProgress& operator=(const FrameProgress&) = delete;

    void update(int done) const;
    double secondsSoFar() const;

  private:
    bool shown_;
    int frames_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// "0:34", "12:05", "1:02:03"
std::string inClockWords(double seconds);

}  // namespace timeshade
