#include "passes/display_pass.h"

namespace timeshade {

void DisplayPass::draw(const Fullscreen& fullscreen, const gl::Texture& radiance, float scale, bool toneMap,
                       const gl::Texture& picture) {
    const gl::Program& program = programs_.get(
        {"display", "passes/fullscreen.vert", "passes/display.frag", {{"TONE_MAP", toneMap ? "1" : "0"}}});
    target_.attach(GL_COLOR_ATTACHMENT0, picture);
    target_.setColorCount(1);
    target_.bindForDrawing(picture.width(), picture.height());
    program.use(gl::Inputs().texture("radiance", radiance).set("scale", scale));
    fullscreen.draw(program);
}

}  // namespace timeshade
