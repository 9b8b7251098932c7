// The technique's settings, each under its key. The block's members are generated from their declaration
// (Technique::visitSettings), so that there is no second list of them.
#include "lib/blocks.glsl"

layout(std140, binding = TECHNIQUE_SETTINGS_BINDING) uniform TechniqueSettings{TECHNIQUE_SETTINGS} setting;
