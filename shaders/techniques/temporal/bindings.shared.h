#ifdef __cplusplus
#pragma once
#endif
#include "shared/frame_blocks.shared.h"

// Storage blocks and textures of the technique `temporal`.
#define TUPLE_TIMES_BINDING (TECHNIQUE_STORAGE_BINDING)
#define TUPLE_DEPTHS_BINDING (TECHNIQUE_STORAGE_BINDING + 1)
#define TUPLE_IDS_BINDING (TECHNIQUE_STORAGE_BINDING + 2)
#define TUPLE_COUNTS_BINDING (TECHNIQUE_STORAGE_BINDING + 3)

#define TUPLE_STATIC_UNIT TECHNIQUE_UNIT
#define TUPLE_OFFSETS_UNIT (TECHNIQUE_UNIT + 1)
#define TUPLE_TIMES_UNIT (TECHNIQUE_UNIT + 2)
#define TUPLE_DEPTHS_UNIT (TECHNIQUE_UNIT + 3)
#define TUPLE_IDS_UNIT 12
#define TUPLE_COVERAGE_UNIT 14

// Where the covers of moving triangles find their numbers while the map is drawn.
#define COVER_TRIANGLES_UNIT TECHNIQUE_UNIT

// The published form: tuples in linked lists.
#define LINKED_HEADS_BINDING (TECHNIQUE_STORAGE_BINDING)
#define LINKED_TUPLES_BINDING (TECHNIQUE_STORAGE_BINDING + 1)
#define LINKED_TUPLE_WORDS 6
#define NO_TUPLE 0xffffffffu
