#include "window/mouse_queue.h"

namespace timeshade {

void MouseQueue::pressed(int button, bool down) {
    if (button >= 0 && button < static_cast<int>(state_.down.size())) events_.push_back({0.0, 0.0, button, down});
}

MouseState MouseQueue::next() {
    std::array<bool, 3> changed{};
    bool anyChanged = false, anyMoved = false;
    while (!events_.empty()) {
        const Event event = events_.front();
        if (event.button < 0) {
            if (anyChanged) break;
            anyMoved = true;
            state_.x = event.x;
            state_.y = event.y;
        } else {
            const auto button = static_cast<std::size_t>(event.button);
            if (changed[button] || (anyMoved && !event.down)) break;
            anyChanged = changed[button] = true;
            state_.down[button] = event.down;
        }
        events_.pop_front();
    }
    return state_;
}

}  // namespace timeshade
