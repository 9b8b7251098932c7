#pragma once

#include <chrono>
#include <fstream>
#include <string>

namespace timeshade {

/// For tests and for whoever looks into how alive the window is: a line for every frame of the window in the file that
/// the environment variable TIMESHADE_FRAME_LOG names: milliseconds since the start, in the pause of which work it was
/// drawn ("first" and "second" picture, "other"), "idle" or, where there was nothing to do since the frame before,
/// "rest", slices of work so far, and what could not be left. Does nothing without that variable.
class FrameLog {
  public:
    FrameLog();
    void frame(const char* work, int slices, const std::string& announced);

  private:
    std::ofstream file_;
    std::chrono::steady_clock::time_point begin_;
};

}  // namespace timeshade
