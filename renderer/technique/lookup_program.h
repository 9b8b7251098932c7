#pragma once

#include <string>

#include "gl/inputs.h"
#include "gl/shader_source.h"

namespace timeshade {

/// Which casters a lookup has to look at.
enum class Casters {
    All,
    Static  ///< those that are static in the light's frame; what is dynamic is left out (STATIC_CASTERS_ONLY)
};

/// How a technique tells whether a receiver is lit, from what it has built: a fragment shader that includes
/// lib/lookup.glsl, says litOf or, where the technique's footprint is longer than an instant, litOver, and includes
/// lib/lookup_main.glsl last. The frame draws it, once a stratum, and gives it the defines of the views, of the
/// footprint and of the technique's settings besides these.
struct LookupProgram {
    std::string label;
    std::string fragment;  ///< path under shaders/
    gl::ShaderDefines defines;
    gl::Inputs inputs;  ///< by the shader's own names
};

}  // namespace timeshade
