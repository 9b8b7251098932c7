#include "technique/summed_view.h"

#include <array>

namespace timeshade {

void drawSummedView(const TechniqueFrame& frame, const gl::Program& program, ViewTarget& target,
                    const gl::Texture& values) {
    program.set("share", 1.0f / static_cast<float>(frame.plan.block.strata));
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    const gl::Framebuffer& framebuffer = target.bind(values);
    const std::array<GLfloat, 4> zero{};
    glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, zero.data());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    for (std::uint32_t stratum = 0; stratum < frame.plan.block.strata; ++stratum) {
        program.set("stratum", stratum);
        frame.fullscreen.draw(program);
    }
    glDisable(GL_BLEND);
}

}  // namespace timeshade
