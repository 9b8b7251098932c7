#pragma once

#include <optional>

#include "plan/frame_request.h"
#include "window/playback.h"

namespace timeshade {

/// Which frame is drawn and how finely: time, shutter and sampling. The playback loops at the shutter's frame rate.
struct Moment {
    FrameRequest request;  ///< width and height are those of the picture's place in the window
    Playback playback;
    std::optional<double> instant;  ///< the one instant of the shutter that is drawn, u in [0, 1]; none for all of it

    /// Starts from a request, of a scene whose motion lasts `duration` seconds. What plays goes on playing.
    void begin(const FrameRequest& first, double duration);
    void setShutter(const Shutter& shutter, double duration);
    /// The clock has moved on by so many seconds: a frame, or an instant of the shutter.
    void advance(double seconds);
    /// Steps through the instants of the shutter, by a share of it.
    void stepInstant(double by);
};

}  // namespace timeshade
