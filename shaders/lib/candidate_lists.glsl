// Lists of the triangles that might shadow something (renderer/technique/candidate_lists.h), for lookups.
//
// DYNAMIC_TRIANGLES, STATIC_TRIANGLES: there are such. STATIC_CASTERS_TRAVEL: some of the latter move with the light.
#include "lib/least_depth.glsl"
#include "lib/texel_lists.glsl"
#include "shared/candidate_bounds.shared.h"

uniform usamplerBuffer dynamicOffsets;
uniform usamplerBuffer dynamicCandidates;  // triangle, where it is
uniform usamplerBuffer staticOffsets;
uniform usamplerBuffer staticCandidates;
uniform uint dynamicSide;
uniform uint buckets;
uniform uint staticSide;

#ifdef STATIC_CASTERS_TRAVEL
const bool staticCastersTravel = true;
#else
const bool staticCastersTravel = false;
#endif

uint maskOf(bvec4 each) { return uint(each.x) | uint(each.y) << 1u | uint(each.z) << 2u | uint(each.w) << 3u; }

// Which of four candidates can shadow a receiver at `place`: one bit each.
uint reachingOf(uvec4 bounds, uint place) {
    return maskOf(equal((uvec4(place) - bounds) & uvec4(CANDIDATE_GUARDS), uvec4(CANDIDATE_GUARDS)));
}
