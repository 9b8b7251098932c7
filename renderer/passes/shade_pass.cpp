#include "passes/shade_pass.h"

#include "shared/shutter_response.shared.h"

namespace timeshade {

namespace {

/// What of the frame itself decides how it is shaded.
gl::ShaderDefines definesOf(const FramePlan& plan, View view) {
    gl::ShaderDefines defines;
    if (plan.camera.turns) defines.emplace_back("CAMERA_TURNS", "1");
    if (view == View::Visibility) {
        defines.emplace_back("VIEW_VISIBILITY", "1");
        return defines;
    }
    if (!plan.mesh->topology->colours.empty()) defines.emplace_back("VERTEX_COLOURS", "1");
    if (!plan.mesh->topology->moreCoordinates.empty()) defines.emplace_back("MORE_COORDINATES", "1");
    return defines;
}

}  // namespace

void ShadePass::draw(const FramePlan& plan, const Fullscreen& fullscreen, const SampleBuffer& samples,
                     const VisibilityBuffer& visibility, View view, bool add, const gl::Texture& radiance) {
    gl::ShaderDefines defines = definesOf(plan, view);
    // A single sample is its own mean.
    if (plan.block.response != SHUTTER_BOX && plan.block.wholeStrata > 1) defines.emplace_back("SHUTTER_WEIGHTS", "1");
    const gl::Program& program = programs_.get({"shade", "passes/fullscreen.vert", "passes/shade.frag", defines});
    samples.ids().bind(SAMPLE_IDS_UNIT);
    visibility.lit().bind(VISIBILITY_UNIT);
    target_.attach(GL_COLOR_ATTACHMENT0, radiance);
    target_.setColorCount(1);
    target_.bindForDrawing(radiance.width(), radiance.height());
    if (add) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    }
    fullscreen.draw(program);
    glDisable(GL_BLEND);
}

void ShadePass::draw(const FramePlan& plan, const Fullscreen& fullscreen, const Parts& parts, View view,
                     const gl::Texture& radiance) {
    gl::ShaderDefines defines = definesOf(plan, view);
    defines.emplace_back("INTERVAL_SAMPLES", "1");
    if (parts.solved) defines.emplace_back("SOLVES_INTERVALS", "1");
    const gl::Program& program =
        programs_.get({"shade intervals", "passes/fullscreen.vert", "passes/shade.frag", defines});
    gl::Inputs inputs;
    inputs.texture("seenParts", parts.parts)
        .texture("partsOfPositions", parts.heads)
        .texture("visibilityOfParts", parts.values);
    program.use(inputs);
    target_.attach(GL_COLOR_ATTACHMENT0, radiance);
    target_.setColorCount(1);
    target_.bindForDrawing(radiance.width(), radiance.height());
    fullscreen.draw(program);
}

}  // namespace timeshade
