#include "passes/display_pass.h"

#include <cmath>

namespace timeshade {

void DisplayPass::draw(const Fullscreen& fullscreen, const gl::Texture& radiance, float scale, const DisplayLook& look,
                       const gl::Texture& picture) {
    const char* curve = look.toneMap == ToneMap::Filmic ? "1" : look.toneMap == ToneMap::Reinhard ? "2" : "0";
    const float exposed = scale * static_cast<float>(std::exp2(look.exposure));
    const gl::Program& program =
        programs_.get({"display", "passes/fullscreen.vert", "passes/display.frag", {{"TONE_MAP", curve}}});
    target_.attach(GL_COLOR_ATTACHMENT0, picture);
    target_.setColorCount(1);
    target_.bindForDrawing(picture.width(), picture.height());
    program.use(gl::Inputs().texture("radiance", radiance).set("scale", exposed));
    fullscreen.draw(program);
}

}  // namespace timeshade
