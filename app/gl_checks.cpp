#include "gl_checks.h"

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade {

DriverWatch::DriverWatch(bool on) {
    if (on) log_.emplace();
}

void DriverWatch::requireSilence() const {
    if (log_ && !log_->messages().empty())
        throw Error(fmt::format("the driver complained {} times, first: {}", log_->messages().size(),
                                log_->messages().front()));
}

}  // namespace timeshade
