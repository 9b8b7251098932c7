#include "window/frame_log.h"

#include <cstdlib>

#include <fmt/format.h>

namespace timeshade {

FrameLog::FrameLog() : begin_(std::chrono::steady_clock::now()) {
    if (const char* path = std::getenv("TIMESHADE_FRAME_LOG")) file_.open(path);
}

void FrameLog::frame(const char* work, int slices, const std::string& announced) {
    if (!file_.is_open()) return;
    const std::chrono::duration<double, std::milli> since = std::chrono::steady_clock::now() - begin_;
    file_ << fmt::format("{:.1f} {} {} {}\n", since.count(), work, slices, announced) << std::flush;
}

}  // namespace timeshade
