#pragma once

#include <string>

namespace timeshade {

/// What moves inside a shutter otherwise than it is drawn.
struct PathWarning {
    enum class Kind { Bent, Jump, Camera, Light, Map } kind;
    double size;       ///< pixels, or texels of the shadow map
    std::string text;  ///< one line
};

}  // namespace timeshade
