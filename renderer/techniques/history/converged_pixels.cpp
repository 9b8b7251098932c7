#include "techniques/history/converged_pixels.h"

#include "shared/history.shared.h"

namespace timeshade {

ConvergedPixels::ConvergedPixels(gl::ProgramCache& programs)
    : programs_(programs), target_("invalidated pixels target") {
    target_.setColorCount(0);
}

void ConvergedPixels::allocate(const TechniqueFrame& frame) {
    const gl::Texture& lit = frame.visibility.lit();
    if (lit_ && lit_->width() == lit.width() && lit_->height() == lit.height() && lit_->layers() == lit.layers())
        return;
    known_ = false;
    periods_ = gl::Texture::image2D("re-test periods", GL_R32UI, lit.width(), lit.height());
    marks_ = gl::Texture::array2D("invalidated pixels", GL_DEPTH_COMPONENT32F, lit.width(), lit.height(), 1);
    lit_ = gl::Texture::array2D("visibility of converged pixels", GL_R32F, lit.width(), lit.height(), lit.layers());
    target_.attach(GL_DEPTH_ATTACHMENT, *marks_);
}

void ConvergedPixels::invalidate(const TechniqueFrame& frame, const gl::Texture& written,
                                 const std::optional<DynamicCasters>& dynamicCasters) {
    gl::ShaderDefines defines = frame.defines();
    gl::Inputs inputs;
    inputs.texture("past", written).texture("periods", *periods_);
    if (dynamicCasters) {
        defines.emplace_back("DYNAMIC_CASTERS", "1");
        inputs.texture("dynamicMask", dynamicCasters->mask).texture("dynamicFlags", dynamicCasters->flags);
        if (const gl::Texture* dynamicPixels = frame.samples.dynamicPixels()) {
            defines.emplace_back("DYNAMIC_SEEN", "1");
            inputs.texture("dynamicPixels", *dynamicPixels);
        }
    }
    const gl::Program& program =
        programs_.get({"invalidated pixels", "passes/fullscreen.vert", "techniques/history/invalidate.frag", defines});
    program.use(inputs);
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_ALWAYS);
    target_.bindForDrawing(marks_->width(), marks_->height());
    const float unmarked = 1.0f;
    glClearNamedFramebufferfv(target_.name(), GL_DEPTH, 0, &unmarked);
    frame.fullscreen.draw(program);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
}

void ConvergedPixels::show(const TechniqueFrame& frame) {
    const gl::Texture& lit = frame.visibility.lit();
    glCopyImageSubData(lit_->name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, lit.name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0,
                       lit.width(), lit.height(), lit.layers());
    known_ = true;
}

std::size_t ConvergedPixels::bytes() const {
    std::size_t sum = 0;
    for (const auto* texture : {&periods_, &marks_, &lit_}) sum += *texture ? (*texture)->bytes() : 0;
    return sum;
}

}  // namespace timeshade
