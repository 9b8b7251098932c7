#include "record/frame_progress.h"

#include "standard_error.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <unistd.h>

namespace timeshade {

FrameProgress::FrameProgress(int frames) : shown_(isatty(STDERR_FILENO) == 1), frames_(frames) {}

FrameProgress::~FrameProgress() {
    if (shown_) writeToStandardError("\r\033[K");
}

double FrameProgress::secondsSoFar() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void FrameProgress::update(int done) const {
    if (!shown_) return;
    const std::string left =
        done > 0 ? fmt::format(", {} left", inClockWords(secondsSoFar() / done * (frames_ - done))) : "";
    writeToStandardError(fmt::format("\r\033[Ktimeshade: frame {} of {}{}", done, frames_, left));
}

std::string inClockWords(double seconds) {
    const long whole = std::lround(std::max(0.0, seconds));
    const long hours = whole / 3600, minutes = whole / 60 % 60;
    return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60)
                     : fmt::format("{}:{:02}", minutes, whole % 60);
}

}  // namespace timeshade
