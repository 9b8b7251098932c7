#include "window/slices.h"

#include "measure/stopwatch.h"

namespace timeshade {

using Clock = std::chrono::steady_clock;

namespace {

/// Counts the time even where the pause ends the work.
struct PauseTime {
    Clock::time_point begin = Clock::now();
    ~PauseTime() { countPause(millisecondsSince(begin)); }
};

}  // namespace

Slices::Work::Work(Slices& slices) : slices_(slices), before_(exchangePauseHook(&slices)) {
    slices_.begin_ = Clock::now();
}

Slices::Work::~Work() {
    exchangePauseHook(before_);
    slices_.announced_.clear();
}

bool Slices::isDue() const { return Clock::now() - begin_ >= length_; }

void Slices::pause() {
    const PauseTime time;
    ++ended_;
    announced_.clear();
    drawWindow();
    if (!isUnwanted_()) return;
    ++cancelled_;
    throw WorkCancelled();
}

void Slices::announce(const std::string& text) {
    const PauseTime time;
    announced_ = text;
    drawWindow();
}

void Slices::drawWindow() {
    drawWindow_();
    begin_ = Clock::now();
}

}  // namespace timeshade
