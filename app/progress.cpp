#include "progress.h"

#include "standard_error.h"

#include <unistd.h>

#include <fmt/format.h>

namespace timeshade {

Progress::Progress(int steps) : shown_(steps > 1 && isatty(STDERR_FILENO) == 1), steps_(steps) {}

Progress::~Progress() {
    if (shown_) writeToStandardError(fmt::format("\r{:40}\r", ""));
}

void Progress::update(int done) const {
    if (shown_ && (done % 8 == 0 || done == steps_))
        writeToStandardError(fmt::format("\rtimeshade: render {} of {} ", done, steps_));
}

}  // namespace timeshade
