#pragma once

namespace timeshade {

/// Maps any time to the time of a clip that repeats.
class ClipClock {
  public:
    /// loops: the clip's end joins its start without a jump.
    ClipClock(double duration, bool loops) : duration_(duration), loops_(loops) {}

    /// Clip time in [0, duration); 0 if the duration is 0.
    double wrapped(double seconds) const;

    /// Clip time at a share (0 to 1) of a shutter; openSeconds <= closeSeconds. A shutter that passes the end of the
    /// clip continues at its start if the clip loops, and is clamped to its end otherwise.
    double during(double openSeconds, double closeSeconds, double share) const;

    /// closeSeconds, clamped to the end of the repetition that openSeconds is in (see Scene::heldCloseSeconds).
    double heldClose(double openSeconds, double closeSeconds) const;

  private:
    double duration_;
    bool loops_;
};

}  // namespace timeshade
