#pragma once

#include <cstddef>

namespace timeshade::gl {

/// Runs the compute program in use over at least so many work groups. A device may take no more than 65,535 in a row,
/// so they are arranged in rows of equal length, or one after the other in pieces where work may pause: shaders number
/// themselves by lib/work_groups.glsl, and return where the number is beyond what they have to do. Nothing happens for
/// 0 groups. Throws LimitError where the device does not take so many in any arrangement.
void dispatch(std::size_t groups);

/// Work groups that hold so many invocations.
inline constexpr std::size_t groupsFor(std::size_t invocations, std::size_t groupSize) {
    return (invocations + groupSize - 1) / groupSize;
}

}  // namespace timeshade::gl
