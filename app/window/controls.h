#pragma once

#include <array>
#include <vector>

#include "window/layout.h"
#include "window/session.h"
#include "window/window_events.h"

namespace timeshade {

/// Does what the keys say. True when the window is to close.
bool applyKeys(Session& session, const std::vector<KeyPress>& keys);

/// The mouse over the picture: the seam of a wipe, orbit, pan, zoom, focus, and with Ctrl the light; and the keys that
/// fly while they are held. Knows whether a drag began there.
class PictureMouse {
  public:
    /// Which keys fly is decided when they are pressed: with Ctrl they are commands, though Ctrl may be let go first.
    void press(const std::vector<KeyPress>& keys);
    void apply(Session& session, const Area& picture);
    bool dragging() const { return dragging_; }
    bool flying() const { return flying_; }

  private:
    void fly(Session& session);

    bool flying_ = false;
    std::array<bool, 6> flightKeys_{};  ///< those down that were pressed on their own
    double flownUntil_ = 0.0;           ///< of the session's clock
    bool dragging_ = false;
    bool movingSeam_ = false;
    bool movingLight_ = false;
};

}  // namespace timeshade
