#include "window/slices.h"

namespace timeshade {

using Clock = std::chrono::steady_clock;

Slices::Work::Work(Slices& slices) : slices_(slices), before_(exchangePauseHook(&slices)) {
    slices_.begin_ = Clock::now();
}

Slices::Work::~Work() {
    exchangePauseHook(before_);
    slices_.announced_.clear();
}

bool Slices::isDue() const { return Clock::now() - begin_ >= length_; }

void Slices::pause() {
    ++ended_;
    announced_.clear();
    drawWindow();
    if (!isUnwanted_()) return;
    ++cancelled_;
    throw WorkCancelled();
}

void Slices::announce(const std::string& text) {
    announced_ = text;
    drawWindow();
}

void Slices::drawWindow() {
    drawWindow_();
    begin_ = Clock::now();
}

}  // namespace timeshade
