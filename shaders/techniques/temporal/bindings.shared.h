#ifdef __cplusplus
#pragma once
#endif
#include "shared/frame_blocks.shared.h"

// Storage blocks of the technique `temporal`.
#define TUPLE_TIMES_BINDING (TECHNIQUE_STORAGE_BINDING)
#define TUPLE_DEPTHS_BINDING (TECHNIQUE_STORAGE_BINDING + 1)
#define TUPLE_IDS_BINDING (TECHNIQUE_STORAGE_BINDING + 2)
#define TUPLE_COUNTS_BINDING (TECHNIQUE_STORAGE_BINDING + 3)

// The published form: tuples in linked lists.
#define LINKED_HEADS_BINDING (TECHNIQUE_STORAGE_BINDING)
#define LINKED_TUPLES_BINDING (TECHNIQUE_STORAGE_BINDING + 1)
