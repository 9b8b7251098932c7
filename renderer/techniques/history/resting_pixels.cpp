#include "techniques/history/resting_pixels.h"

#include "shared/history.shared.h"

namespace timeshade {

RestingPixels::RestingPixels(gl::ProgramCache& programs) : programs_(programs), target_("woken pixels target") { target_.setColorCount(0); }

void RestingPixels::allocate(const TechniqueFrame& frame) {
    const gl::Texture& lit = frame.visibility.lit();
    if (answers_ && answers_->width() == lit.width() && answers_->height() == lit.height() && answers_->layers() == lit.layers()) return;
    known_ = false;
    rests_ = gl::Texture::image2D("resting pixels", GL_R32UI, lit.width(), lit.height());
    marks_ = gl::Texture::array2D("woken pixels", GL_DEPTH_COMPONENT32F, lit.width(), lit.height(), 1);
    answers_ = gl::Texture::array2D("answers of resting pixels", GL_R32F, lit.width(), lit.height(), lit.layers());
    target_.attach(GL_DEPTH_ATTACHMENT, *marks_);
}

void RestingPixels::wake(const TechniqueFrame& frame, const gl::Texture& written, const Movers* movers) {
    gl::ShaderDefines defines;
    if (frame.plan.light.projection == Projection::Orthographic) defines.emplace_back("LIGHT_ORTHOGRAPHIC", "1");
    if (movers) defines.emplace_back("MOVERS", "1");
    if (movers && frame.touched) defines.emplace_back("MOVING_SEEN", "1");
    const gl::Program& program = programs_.get({"woken pixels", "passes/fullscreen.vert", "techniques/history/waking.frag", defines});
    written.bind(TECHNIQUE_UNIT + 1);
    rests_->bind(RESTS_UNIT);
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    if (movers) {
        movers->mask.bind(TECHNIQUE_UNIT + 3);
        movers->flags.bind(MOVER_FLAGS_UNIT);
        if (frame.touched) frame.touched->bind(TOUCHED_UNIT);
    }
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

void RestingPixels::show(const TechniqueFrame& frame) {
    const gl::Texture& lit = frame.visibility.lit();
    glCopyImageSubData(answers_->name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, lit.name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, lit.width(), lit.height(), lit.layers());
    known_ = true;
}

std::size_t RestingPixels::bytes() const {
    std::size_t sum = 0;
    for (const auto* texture : {&rests_, &marks_, &answers_}) sum += *texture ? (*texture)->bytes() : 0;
    return sum;
}

} // namespace timeshade
