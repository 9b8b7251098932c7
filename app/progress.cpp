#include "progress.h"

#include <unistd.h>
#include <cstdio>

#include <fmt/format.h>

namespace timeshade {

Progress::Progress(int steps) : shown_(steps > 1 && isatty(STDERR_FILENO) == 1), steps_(steps) {}

Progress::~Progress() {
    if (shown_) fmt::print(stderr, "\r{:40}\r", "");
}

void Progress::update(int done) const {
    if (shown_ && (done % 8 == 0 || done == steps_)) fmt::print(stderr, "\rtimeshade: render {} of {} ", done, steps_);
}

}  // namespace timeshade
