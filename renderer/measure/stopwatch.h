#pragma once

#include <chrono>

namespace timeshade {

/// By the clock on the wall.
inline double millisecondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace timeshade
