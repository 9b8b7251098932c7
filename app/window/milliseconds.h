#pragma once

#include <string>

#include <fmt/format.h>

namespace timeshade {

/// "0.1234 ms", "12.34 ms", "12345 ms": four digits or all before the point.
inline std::string inMilliseconds(double value) {
    return value < 1000.0 ? fmt::format("{:.4g} ms", value) : fmt::format("{:.0f} ms", value);
}

}  // namespace timeshade
