// The uniform blocks that every shader of a frame may read. CAMERA and LIGHT share one struct.
#include "shared/frame_blocks.shared.h"

layout(std140, binding = FRAME_BLOCK_BINDING) uniform FrameUniforms { FrameBlock frame; };
layout(std140, binding = CAMERA_VIEW_BINDING) uniform CameraUniforms { ViewBlock cameraView; };
layout(std140, binding = LIGHT_VIEW_BINDING) uniform LightUniforms { ViewBlock lightView; };
