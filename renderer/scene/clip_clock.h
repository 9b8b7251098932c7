#pragma once

namespace timeshade {

/// Maps any time to the time of a clip that repeats, or that is held at both of its ends.
class ClipClock {
  public:
    /// loops: the clip's end joins its start without a jump.
    ClipClock(double duration, bool loops) : duration_(duration), loops_(loops) {}

    bool loops() const { return loops_; }

    /// Clip time: in [0, duration) if the clip loops, clamped to [0, duration] otherwise. 0 if the duration is 0.
    double clipTime(double seconds) const;

    /// Clip time at a share (0 to 1) of a shutter; openSeconds <= closeSeconds.
    double during(double openSeconds, double closeSeconds, double share) const;

  private:
    double duration_;
    bool loops_;
};

}  // namespace timeshade
