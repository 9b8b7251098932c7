#pragma once

#include <memory>
#include <optional>
#include <string>

#include "contexts/gl_context.h"
#include "gl/debug_log.h"
#include "options/run_options.h"

namespace timeshade {

/// OpenGL for a command without a window: the context that the options ask for and, with --gl-debug, what its driver
/// complains of. Lives longer than whatever draws with it.
class HeadlessGl {
  public:
    explicit HeadlessGl(const RunOptions& options);
    std::string backEnd() const { return context_->backEnd(); }
    /// With --gl-debug: throws Error with the number of complaints and the first of them.
    void requireSilence() const;

  private:
    std::unique_ptr<GlContext> context_;
    std::optional<gl::DebugLog> log_;
};

}  // namespace timeshade
