#pragma once

namespace timeshade {

/// While one lives, SIGINT, SIGTERM and SIGHUP are counted instead of ending the program, so that long work can close
/// its files. System calls that wait are interrupted by them. One at a time.
class StopSignals {
  public:
    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    /// How many have come so far; 0 where none are counted.
    static int count();
    /// "SIGINT", the first that came.
    static const char* name();
};

}  // namespace timeshade
