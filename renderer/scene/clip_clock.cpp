#include "scene/clip_clock.h"

#include <algorithm>
#include <cmath>

namespace timeshade {

double ClipClock::clipTime(double seconds) const {
    if (!(duration_ > 0.0) || !std::isfinite(seconds)) return 0.0;
    if (!loops_) return std::clamp(seconds, 0.0, duration_);
    const double rest = std::fmod(seconds, duration_);
    const double positive = rest < 0.0 ? rest + duration_ : rest;
    return positive < duration_ ? positive : 0.0;  // the sum may round up to the duration
}

double ClipClock::during(double openSeconds, double closeSeconds, double share) const {
    const double from = loops_ ? clipTime(openSeconds) : openSeconds;
    return clipTime(from + share * (closeSeconds - openSeconds));
}

}  // namespace timeshade
