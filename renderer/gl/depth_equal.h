#pragma once

#include <glad/gl.h>

namespace timeshade::gl {

/// While it lives, a fragment passes where its depth is the one that is stored, and none is stored: what is drawn is
/// confined to what a depth buffer marks. Afterwards the depth test is off, as passes find it.
class DepthEqual {
  public:
    DepthEqual() {
        glEnable(GL_DEPTH_TEST);
        glDepthMask(GL_FALSE);
        glDepthFunc(GL_EQUAL);
    }
    ~DepthEqual() {
        glDepthMask(GL_TRUE);
        glDepthFunc(GL_GREATER);
        glDisable(GL_DEPTH_TEST);
    }
    DepthEqual(const DepthEqual&) = delete;
    DepthEqual& operator=(const DepthEqual&) = delete;
};

}  // namespace timeshade::gl
