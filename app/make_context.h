#pragma once

#include <memory>

#include "contexts/gl_context.h"

namespace timeshade {

/// The context that headless work asks for: EGL or OSMesa, or a hidden window for `--context window`.
std::unique_ptr<GlContext> makeContext(ContextOptions options, bool debug);

}  // namespace timeshade
