#pragma once

#include "gl/fragment_count.h"
#include "gl/framebuffer.h"
#include "gl/pause_point.h"
#include "gl/program.h"
#include "gl/vertex_array.h"

namespace timeshade {

/// One triangle over the whole viewport (passes/fullscreen.vert); the fragment shader does the work, which may pause.
class Fullscreen {
  public:
    Fullscreen() : none_("no attributes") {}
    /// Draws into the framebuffer that is bound. Depth test and blending are as the caller left them. Counts the
    /// fragments that pass, where that is wished.
    void draw(const gl::Program& program, gl::FragmentCount* count = nullptr) const {
        program.use();
        glBindVertexArray(none_.name());
        if (count != nullptr) count->restart();
        gl::drawInBands([&] {
            if (count != nullptr) count->begin();
            glDrawArrays(GL_TRIANGLES, 0, 3);
            if (count != nullptr) count->end();
        });
    }
    const gl::VertexArray& noAttributes() const { return none_; }

  private:
    gl::VertexArray none_;
};

}  // namespace timeshade
