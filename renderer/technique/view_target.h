#pragma once

#include <optional>

#include "gl/framebuffer.h"

namespace timeshade {

/// Where a technique draws a view of its own (Technique::drawView). Made at its first use, since techniques are made
/// without OpenGL.
class ViewTarget {
  public:
    /// What is drawn next goes into `values`, all of it.
    const gl::Framebuffer& bind(const gl::Texture& values) {
        if (!framebuffer_) framebuffer_.emplace("view target");
        framebuffer_->setColorCount(1);
        framebuffer_->attach(GL_COLOR_ATTACHMENT0, values);
        framebuffer_->bindForDrawing(values.width(), values.height());
        return *framebuffer_;
    }

  private:
    std::optional<gl::Framebuffer> framebuffer_;
};

}  // namespace timeshade
