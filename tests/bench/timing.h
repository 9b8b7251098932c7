#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

#include "measure/stopwatch.h"

namespace timeshade {

double millisecondsOf(const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return millisecondsSince(begin);
}

/// Of an even number the upper one.
inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace timeshade
