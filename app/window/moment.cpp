#include "window/moment.h"

#include <algorithm>
#include <cmath>

namespace timeshade {

void Moment::begin(const FrameRequest& first, double duration) {
    request = first;
    const bool playing = playback.playing();
    playback.setLoop(duration, request.shutter.framesPerSecond);
    playback.jump(request.frame);
    playback.play(playing);
}

void Moment::setShutter(const Shutter& shutter, double duration) {
    request.shutter = shutter;
    playback.setLoop(duration, shutter.framesPerSecond);
}

void Moment::advance(double seconds) {
    if (!instant || !playback.playing()) return playback.advance(seconds);
    const double open = std::max(request.shutter.closeSeconds(0.0) - request.shutter.openSeconds(0.0), 1e-6);
    *instant = std::fmod(*instant + seconds * playback.speed() / open, 1.0);
}

void Moment::stepInstant(double by) {
    playback.play(false);
    instant = std::clamp(instant.value_or(by > 0.0 ? 0.0 - by : 1.0 - by) + by, 0.0, 1.0);
}

}  // namespace timeshade
