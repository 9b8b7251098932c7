#include "scene/clip_clock.h"

#include <algorithm>
#include <cmath>

namespace timeshade {

double ClipClock::wrapped(double seconds) const {
    if (!(duration_ > 0.0) || !std::isfinite(seconds)) return 0.0;
    const double rest = std::fmod(seconds, duration_);
    const double positive = rest < 0.0 ? rest + duration_ : rest;
    return positive < duration_ ? positive : 0.0;  // the sum may round up to the duration
}

double ClipClock::during(double openSeconds, double closeSeconds, double share) const {
    const double time = wrapped(openSeconds) + share * (closeSeconds - openSeconds);
    return loops_ ? wrapped(time) : std::min(time, duration_);
}

double ClipClock::heldClose(double openSeconds, double closeSeconds) const {
    const double left = duration_ - wrapped(openSeconds);
    if (loops_ || closeSeconds - openSeconds < left) return closeSeconds;
    return openSeconds + left - 1e-9 * duration_;  // the exact end would wrap to the start
}

}  // namespace timeshade
