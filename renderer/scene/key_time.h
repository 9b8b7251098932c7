#pragma once

#include <cmath>

namespace timeshade {

/// How far a time may lie before a key and still count as the key's: files keep key times as floats, and exporters
/// compute them in float, while a frame's time is a double. Eight units in the last place of a float, in seconds: at
/// 1 s it is half of a millionth, at an hour 2 ms.
inline double keyTimeSlack(double seconds) { return 8.0 / 16777216.0 * std::abs(seconds); }

}  // namespace timeshade
