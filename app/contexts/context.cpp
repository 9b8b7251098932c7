#include "contexts/back_ends.h"
#include "core/error.h"

#include <fmt/format.h>

#include <stdexcept>

namespace timeshade {
namespace {

std::unique_ptr<GlContext> makeAnyContext(const ContextOptions& options) {
    try {
        return makeEglContext(options);
    } catch (const Error& eglError) {
        // A device was asked for by number: another renderer in its place would be a silent lie.
        if (options.device >= 0) {
            throw;
        }
        try {
            return makeOsMesaContext(options);
        } catch (const Error& osMesaError) {
            throw Error(fmt::format("no headless OpenGL context: {}; {}", eglError.what(), osMesaError.what()));
        }
    }
}

}  // namespace

std::unique_ptr<GlContext> makeHeadlessContext(const ContextOptions& options) {
    switch (options.kind) {
    case ContextKind::Auto: return makeAnyContext(options);
    case ContextKind::Egl: return makeEglContext(options);
    case ContextKind::OsMesa: return makeOsMesaContext(options);
    case ContextKind::Window: break;
    }
    throw std::logic_error("makeHeadlessContext makes no windows: see contexts/window_context.h");
}

}  // namespace timeshade
