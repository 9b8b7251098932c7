#pragma once

#include "window/layout.h"
#include "window/session.h"
#include "window/window_events.h"

namespace timeshade {

/// Does what the keys say. True when the window is to close.
bool applyKeys(Session& session, const std::vector<KeyPress>& keys);

/// The mouse over the picture: the seam of a wipe, orbit, pan, zoom, and with Ctrl the light. Knows whether a drag
/// began there.
class PictureMouse {
  public:
    void apply(Session& session, const Area& picture);
    bool dragging() const { return dragging_; }

  private:
    bool dragging_ = false;
    bool movingSeam_ = false;
    bool movingLight_ = false;
};

}  // namespace timeshade
