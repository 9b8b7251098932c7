#pragma once

#include "contexts/gl_context.h"

#include <glad/gl.h>

#include <memory>
#include <string>
#include <string_view>

namespace timeshade {

/// The back ends, each tried on its own. Throw Error with one line that begins with the back end's name.
std::unique_ptr<GlContext> makeEglContext(const ContextOptions& options);
std::unique_ptr<GlContext> makeOsMesaContext(const ContextOptions& options);

/// Loads OpenGL's functions for the context that is current. Throws Error if it is older than 4.5, with the vendor,
/// renderer and version found. The functions are the process's: the context loaded last owns them.
void loadOpenGl(GLADloadfunc loader, std::string_view backEnd);

/// For a context that is current but was made only because 4.5 core was refused: says what the driver has instead.
/// Uses nothing but the loader, never throws.
std::string describeTooOld(GLADloadfunc loader, std::string_view backEnd);

}  // namespace timeshade
