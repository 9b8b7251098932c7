#include "headless_gl.h"

#include <fmt/format.h>

#include "core/error.h"
#include "make_context.h"

namespace timeshade {

HeadlessGl::HeadlessGl(const RunOptions& options) : context_(makeContext(options.context, options.debugGl)) {
    if (options.debugGl) log_.emplace();
}

void HeadlessGl::requireSilence() const {
    if (log_ && !log_->messages().empty())
        throw Error(fmt::format("the driver complained {} times, first: {}", log_->messages().size(),
                                log_->messages().front()));
}

}  // namespace timeshade
