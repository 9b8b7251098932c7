#pragma once

#include "gl/buffer.h"
#include "technique/stored_along_line.h"

namespace timeshade {

/// Adds the entries of linked lists of intervals (shared/linked_intervals.shared.h), one list a texel of the light's
/// map, along a line. An entry's depth is linear in u as an NDC depth; a mark's is linear between the same two ends.
void addLinkedMarks(const FramePlan& plan, const gl::Buffer& heads, const gl::Buffer& intervals, const MapLine& line,
                    std::vector<StoredMark>& marks);

/// Number of a texel's list among all.
std::size_t listNumber(const FramePlan& plan, const glm::ivec2& texel);

}  // namespace timeshade
