#pragma once

#include <array>

#include <glad/gl.h>

namespace timeshade {

/// What UiWindow::endFrame changes of OpenGL's state and Dear ImGui does not bring back: as it was, when this ends.
/// So a window can be drawn in the middle of another frame.
class DrawingState {
  public:
    DrawingState();
    ~DrawingState();
    DrawingState(const DrawingState&) = delete;
    DrawingState& operator=(const DrawingState&) = delete;

  private:
    static constexpr GLuint colors = 4;  ///< that frames draw into at most

    GLint framebuffer_ = 0, program_ = 0, clipOrigin_ = 0, clipDepth_ = 0;
    std::array<GLint, 4> viewport_{};
    GLboolean depthTest_ = GL_FALSE, scissorTest_ = GL_FALSE;
    std::array<GLboolean, colors> blends_{};
    std::array<GLint, colors> equations_{};
};

}  // namespace timeshade
