// What all shaders of the technique read: its settings and its uniform block.
#include "lib/light_map.glsl"
#include "lib/settings.glsl"
#include "shared/history.shared.h"

layout(std140, binding = TECHNIQUE_BLOCK_BINDING) uniform HistoryUniforms { HistoryBlock history; };
