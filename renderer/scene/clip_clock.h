#pragma once

namespace timeshade {

/// Turns any time into a time of a clip that plays again and again.
class ClipClock {
  public:
    /// loops: the clip's end joins its start without a jump.
    ClipClock(double duration, bool loops) : duration_(duration), loops_(loops) {}

    /// In [0, duration); 0 where the clip has no length.
    double wrapped(double seconds) const;

    /// Clip time at a share (0 to 1) of a shutter. A shutter that passes the end goes on at the start if the clip
    /// loops and is held at the end otherwise. openSeconds <= closeSeconds.
    double during(double openSeconds, double closeSeconds, double share) const;

    /// The latest time that is not beyond the end of the clip's turn that openSeconds lies in: see Scene.
    double heldClose(double openSeconds, double closeSeconds) const;

  private:
    double duration_;
    bool loops_;
};

}  // namespace timeshade
