#pragma once

#include "gl/framebuffer.h"
#include "gl/pause_point.h"
#include "gl/program.h"
#include "gl/vertex_array.h"

namespace timeshade {

/// One triangle over the whole viewport (passes/fullscreen.vert); the fragment shader does the work, which may pause.
class Fullscreen {
  public:
    Fullscreen() : none_("no attributes") {}
    /// Draws into the framebuffer that is bound. Depth test and blending are as the caller left them.
    void draw(const gl::Program& program) const {
        program.use();
        glBindVertexArray(none_.name());
        gl::drawInBands([] { glDrawArrays(GL_TRIANGLES, 0, 3); });
    }
    const gl::VertexArray& noAttributes() const { return none_; }

  private:
    gl::VertexArray none_;
};

}  // namespace timeshade
