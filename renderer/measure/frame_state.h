#pragma once

#include <optional>
#include <string>

namespace timeshade {

/// What earlier frames have left for a timed one to use. Its programs are compiled in any case.
enum class FrameState {
    Cold,     ///< nothing is cached: the first frame of a sequence, or one after a cut
    Filling,  ///< the second frame: caches fill, which costs more than either using them or having none
    Steady,   ///< a frame of a sequence that has been running
};

/// "cold", "filling", "steady"; and back, nothing for any other word.
std::string nameOf(FrameState state);
std::optional<FrameState> frameStateNamed(const std::string& name);

}  // namespace timeshade
