#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plan/frame_plan.h"

namespace timeshade {

/// How the candidate grid is divided, and what that is expected to cost.
struct CandidateGridSize {
    int side = 0;                     ///< cells along a side of the light's map
    int buckets = 0;                  ///< of the shutter
    double expectedEntries = 0.0;     ///< of all lists
    double expectedCandidates = 0.0;  ///< tested per camera sample
};

/// Chooses side (a power of two, at most the map's longer side) and, of casters that move, buckets (a power of two, at
/// most 32) for the least expected cost of build plus lookup; either may be given instead (0: choose). With bounds of w
/// x h map widths that move by (x, y) in the shutter, a triangle has about 1/2 ((w + x/B) S + 1)((h + y/B) S + 1)
/// entries in each of B buckets; a sample looks at entries / (S^2 B) of them and tests as many as have it in their
/// bounds. Judged by at most 2,048 triangles, evenly picked.
CandidateGridSize chooseCandidateGrid(const FramePlan& plan, const std::vector<std::uint32_t>& casters, bool move,
                                      int side, int buckets);

}  // namespace timeshade
