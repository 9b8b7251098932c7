#include "passes/heat_map_pass.h"

namespace timeshade {

void HeatMapPass::draw(const Fullscreen& fullscreen, const gl::Texture& values, const HeatScale& scale,
                       const gl::Texture& picture) {
    const gl::Program& program = programs_.get({"heat map", "passes/fullscreen.vert", "passes/heat_map.frag", {}});
    target_.attach(GL_COLOR_ATTACHMENT0, picture);
    target_.setColorCount(1);
    target_.bindForDrawing(picture.width(), picture.height());
    program.use(gl::Inputs()
                    .texture("values", values)
                    .set("scale", glm::vec3(static_cast<float>(scale.low), static_cast<float>(scale.high),
                                            scale.logarithmic ? 1.0f : 0.0f)));
    fullscreen.draw(program);
}

}  // namespace timeshade
