#pragma once

#include <array>
#include <deque>

namespace timeshade {

/// Where the mouse is and which of its buttons (left, right, middle) are down.
struct MouseState {
    double x = 0.0, y = 0.0;  ///< window coordinates
    std::array<bool, 3> down{};
};

/// What the mouse has done, in order, handed out frame by frame. A window that draws slowly would otherwise learn of a
/// press only where the mouse is by then, and never of a short one: here a button goes down or up in a frame of its
/// own change, with the mouse where it was at that moment, and what was moved before a release is seen before it.
class MouseQueue {
  public:
    void moved(double x, double y) { events_.push_back({x, y, -1, false}); }
    /// Buttons beyond the third are not for us.
    void pressed(int button, bool down);
    /// What the next frame is to see.
    MouseState next();
    /// True while there is more than the last frame has seen.
    bool pending() const { return !events_.empty(); }

  private:
    struct Event {
        double x, y;
        int button;  ///< -1: it was moved
        bool down;
    };

    std::deque<Event> events_;
    MouseState state_;
};

}  // namespace timeshade
