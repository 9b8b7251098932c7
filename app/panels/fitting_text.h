#pragma once

#include <string>

namespace timeshade {

/// As much of a text as has room beside what ends it, which is kept: its parts, at ", ", go from the last. At least the
/// first part, though it be too long. `room` in units of the window, of the current font.
std::string fittingText(std::string text, const std::string& end, float room);

}  // namespace timeshade
