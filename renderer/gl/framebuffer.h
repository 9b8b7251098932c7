#pragma once

#include <string>

#include "gl/object.h"
#include "gl/texture.h"

namespace timeshade::gl {

struct DeleteFramebuffer {
    void operator()(GLuint name) const { glDeleteFramebuffers(1, &name); }
};

/// A framebuffer whose attachments are set by layer. The textures must outlive it.
class Framebuffer : public Object<DeleteFramebuffer> {
  public:
    explicit Framebuffer(const std::string& labelText);

    /// Attaches one layer of an array (or the only image of a 2D texture). `attachment` is GL_COLOR_ATTACHMENT0.. or
    /// GL_DEPTH_ATTACHMENT.
    void attach(GLenum attachment, const Texture& texture, int layer = 0) const;
    /// Takes an attachment away: one that stays keeps its texture's memory and bounds what can be drawn.
    void detach(GLenum attachment) const { glNamedFramebufferTexture(name(), attachment, 0, 0); }
    /// Colour attachments 0..count-1 are written; 0 for depth only.
    void setColorCount(int count) const;
    /// Makes it the target of drawing, with a viewport of the given size. Asserts that it is complete.
    void bindForDrawing(int width, int height) const;
};

}  // namespace timeshade::gl
