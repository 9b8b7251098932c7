#pragma once

#include <vector>

#include "passes/candidate_grid.h"
#include "technique/stored_along_line.h"

namespace timeshade {

/// Adds the candidates along a line of the map, each over that part of its cell that its bounds leave, its bucket of
/// the shutter, and with the depth that it is never nearer than. Waits for the device.
void addCandidateMarks(const FramePlan& plan, const CandidateGrid& grid, const MapLine& line,
                       std::vector<StoredMark>& marks);

}  // namespace timeshade
