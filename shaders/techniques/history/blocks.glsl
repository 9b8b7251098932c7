// What all shaders of the technique read: its uniforms, and which texture lies where.
#include "lib/light_map.glsl"
#include "shared/history.shared.h"

layout(std140, binding = TECHNIQUE_BLOCK_BINDING) uniform HistoryUniforms { HistoryBlock history; };

#define SHADOW_MAP_UNIT TECHNIQUE_UNIT              // this frame's map
#define PAST_UNIT (TECHNIQUE_UNIT + 1)              // what the frame before has written
#define PREVIOUS_POSITIONS_UNIT (TECHNIQUE_UNIT + 2) // the triangles of the frame before
#define DYNAMIC_MASK_UNIT (TECHNIQUE_UNIT + 3)        // nearest distance at which anything has moved
