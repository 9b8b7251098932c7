#include "make_context.h"

#include "contexts/window_context.h"

namespace timeshade {

std::unique_ptr<GlContext> makeContext(ContextOptions options, bool debug) {
    options.debug = debug;
    if (options.kind != ContextKind::Window) return makeHeadlessContext(options);
    WindowOptions window;
    window.visible = false;
    window.debug = debug;
    return std::make_unique<WindowContext>(window);
}

}  // namespace timeshade
