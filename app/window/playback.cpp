#include "window/playback.h"

#include <algorithm>
#include <cmath>

namespace timeshade {

void Playback::setLoop(double duration, double framesPerSecond) {
    framesPerSecond_ = framesPerSecond;
    // A loop that ends on a whole frame shows that frame as frame 0; the tolerance is for durations in single
    // precision.
    const int frames = static_cast<int>(std::clamp(std::ceil(duration * framesPerSecond - 1e-3), 1.0, 1e6));
    if (frames != loopFrames_ || last_ == 0) setPart(0, frames - 1);
    loopFrames_ = frames;
    if (!moves()) playing_ = false;
}

void Playback::setPart(int first, int last) {
    first_ = first;
    last_ = last;
}

void Playback::play(bool on) {
    playing_ = on && moves();
    unspent_ = 0.0;
}

void Playback::advance(double seconds) {
    if (!playing_) return;
    unspent_ += seconds * framesPerSecond_ * speed_;
    const double whole = std::floor(unspent_);
    if (whole < 1.0) return;
    unspent_ -= whole;
    const int now = std::clamp(frameInLoop(), first_, last_);
    frame_ = first_ + std::fmod(now - first_ + whole, last_ - first_ + 1);
}

void Playback::step(int frames) {
    play(false);
    const int next = (frameInLoop() + frames) % loopFrames_;
    frame_ = next < 0 ? next + loopFrames_ : next;
}

int Playback::frameInLoop() const {
    const double within = frame_ - std::floor(frame_ / loopFrames_) * loopFrames_;
    return std::clamp(static_cast<int>(within), 0, loopFrames_ - 1);
}

}  // namespace timeshade
