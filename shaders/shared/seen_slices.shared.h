#ifdef __cplusplus
#pragma once
#endif
#include "shared/types.shared.h"

// Storage blocks of the passes that solve what positions see, before any technique's.
#define SEEN_PARTS_BINDING 0
#define SEEN_COUNTS_BINDING 1
#define SEEN_SLICES_BINDING 2
#define SEEN_SEGMENTS_BINDING 3

#define SEEN_GROUP 64              // invocations of a work group
#define SEEN_NO_SLICE 0xffffffffu  // in place of a slice's number
#define SEEN_PARTS_IN_ROW 2048u    // values of parts lie in rows of a texture
