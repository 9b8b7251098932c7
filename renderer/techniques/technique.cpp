#include "techniques/technique.h"

#include <fmt/format.h>

#include "scene/error.h"

namespace timeshade {

void LookupPass::draw(const TechniqueFrame& frame, const gl::Program& program) const {
    const gl::Texture& lit = frame.visibility.lit();
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    target_.setColorCount(1);
    program.use();
    for (std::uint32_t stratum = 0; stratum < frame.plan.block.strata; ++stratum) {
        target_.attach(GL_COLOR_ATTACHMENT0, lit, static_cast<int>(stratum));
        target_.bindForDrawing(lit.width(), lit.height());
        glUniform1ui(0, stratum);
        frame.fullscreen.draw(program);
    }
}

void Technique::drawView(const TechniqueFrame&, const std::string& name, const gl::Texture&) {
    throw Error(fmt::format("technique {} has no view '{}'", description().name, name));
}

gl::ShaderDefines viewDefines(const FramePlan& plan) {
    gl::ShaderDefines defines;
    if (plan.camera.turns) defines.emplace_back("CAMERA_TURNS", "1");
    if (plan.light.projection == Projection::Orthographic) defines.emplace_back("LIGHT_ORTHOGRAPHIC", "1");
    return defines;
}

} // namespace timeshade
