#include "window/drawing_state.h"

namespace timeshade {

DrawingState::DrawingState() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
    glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
    glGetIntegerv(GL_CLIP_ORIGIN, &clipOrigin_);
    glGetIntegerv(GL_CLIP_DEPTH_MODE, &clipDepth_);
    glGetIntegerv(GL_VIEWPORT, viewport_.data());
    depthTest_ = glIsEnabled(GL_DEPTH_TEST);
    scissorTest_ = glIsEnabled(GL_SCISSOR_TEST);
    for (GLuint i = 0; i < colors; ++i) {
        blends_[i] = glIsEnabledi(GL_BLEND, i);
        glGetIntegeri_v(GL_BLEND_EQUATION_RGB, i, &equations_[i]);
    }
    // The window fills all of it, whatever band is being drawn.
    glDisable(GL_SCISSOR_TEST);
}

DrawingState::~DrawingState() {
    const auto enable = [](GLenum what, GLboolean on) { on == GL_TRUE ? glEnable(what) : glDisable(what); };
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
    // It may have been dropped while it was in use.
    if (glIsProgram(static_cast<GLuint>(program_)) == GL_TRUE) glUseProgram(static_cast<GLuint>(program_));
    glClipControl(static_cast<GLenum>(clipOrigin_), static_cast<GLenum>(clipDepth_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    enable(GL_DEPTH_TEST, depthTest_);
    enable(GL_SCISSOR_TEST, scissorTest_);
    for (GLuint i = 0; i < colors; ++i) {
        blends_[i] == GL_TRUE ? glEnablei(GL_BLEND, i) : glDisablei(GL_BLEND, i);
        glBlendEquationi(i, static_cast<GLenum>(equations_[i]));
    }
}

}  // namespace timeshade
