#ifdef __cplusplus
#pragma once
#endif
#include "shared/types.shared.h"

// Linked lists of time intervals, one list per texel of the shadow map, as Hong and Oh store them (2017: tuples; 2019:
// depth-time ranges): begin and end in u, NDC depth at either, the triangle's number, the next entry.
#define LINKED_INTERVAL_WORDS 6
#define NO_INTERVAL 0xffffffffu  // end of a list
