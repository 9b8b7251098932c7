#include "scene/looping.h"

#include <algorithm>
#include <cmath>

#include "scene/key_time.h"
#include "scene/scene.h"

namespace timeshade {

ShutterTimes loopedTimes(const Scene& scene, Looping looping, const ShutterTimes& times) {
    const double duration = scene.duration();
    if (looping == Looping::Auto || !(duration > 0.0)) return times;
    if (looping == Looping::On && scene.loops()) return times;
    const double middle = 0.5 * (times.open + times.close);
    const double start =
        looping == Looping::On ? std::floor((middle + keyTimeSlack(middle)) / duration) * duration : 0.0;
    return {std::clamp(times.open - start, 0.0, duration), std::clamp(times.close - start, 0.0, duration)};
}

}  // namespace timeshade
