#include "passes/frame_uniforms.h"

#include <span>

namespace timeshade {

FrameUniforms::FrameUniforms()
    : frame_("frame block", sizeof(shared::FrameBlock)),
      camera_("camera view block", sizeof(shared::ViewBlock)),
      light_("light view block", sizeof(shared::ViewBlock)) {}

void FrameUniforms::set(const FramePlan& plan) {
    frame_.upload(std::span<const shared::FrameBlock>(&plan.block, 1));
    camera_.upload(std::span<const shared::ViewBlock>(&plan.camera.block, 1));
    light_.upload(std::span<const shared::ViewBlock>(&plan.light.block, 1));
    glBindBufferBase(GL_UNIFORM_BUFFER, FRAME_BLOCK_BINDING, frame_.name());
    glBindBufferBase(GL_UNIFORM_BUFFER, CAMERA_VIEW_BINDING, camera_.name());
    glBindBufferBase(GL_UNIFORM_BUFFER, LIGHT_VIEW_BINDING, light_.name());
}

}  // namespace timeshade
