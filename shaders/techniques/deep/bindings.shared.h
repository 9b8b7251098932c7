#ifdef __cplusplus
#pragma once
#endif
#include "shared/frame_blocks.shared.h"

// Storage blocks of the technique `deep`.
#define DEEP_NODES_BINDING (TECHNIQUE_STORAGE_BINDING)
#define DEEP_COUNTS_BINDING (TECHNIQUE_STORAGE_BINDING + 1)
