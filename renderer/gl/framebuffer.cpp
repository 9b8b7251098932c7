#include "gl/framebuffer.h"

#include <array>

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade::gl {

namespace {
GLuint createFramebuffer() {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    return name;
}
}  // namespace

Framebuffer::Framebuffer(const std::string& labelText) : Object(createFramebuffer()) {
    label(GL_FRAMEBUFFER, name(), labelText);
}

void Framebuffer::attach(GLenum attachment, const Texture& texture, int layer) const {
    if (texture.isArray())
        glNamedFramebufferTextureLayer(name(), attachment, texture.name(), 0, layer);
    else
        glNamedFramebufferTexture(name(), attachment, texture.name(), 0);
}

void Framebuffer::setColorCount(int count) const {
    const std::array<GLenum, 4> all{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2,
                                    GL_COLOR_ATTACHMENT3};
    if (count == 0) {
        glNamedFramebufferDrawBuffer(name(), GL_NONE);
        glNamedFramebufferReadBuffer(name(), GL_NONE);
        return;
    }
    glNamedFramebufferDrawBuffers(name(), count, all.data());
    glNamedFramebufferReadBuffer(name(), GL_COLOR_ATTACHMENT0);
}

void Framebuffer::bindForDrawing(int width, int height) const {
    const GLenum status = glCheckNamedFramebufferStatus(name(), GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error(fmt::format("the driver refuses a framebuffer of {} x {} (status {:#x})", width, height, status));
    glBindFramebuffer(GL_FRAMEBUFFER, name());
    glViewport(0, 0, width, height);
}

}  // namespace timeshade::gl
