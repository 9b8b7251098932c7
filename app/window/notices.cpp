#include "window/notices.h"

#include <utility>

namespace timeshade {

namespace {

constexpr double secondsShown = 6.0, secondsShownBad = 12.0;

}  // namespace

void Notices::show(std::string text, bool bad, double now) {
    current_ = Notice{std::move(text), bad, now + (bad ? secondsShownBad : secondsShown)};
}

void Notices::advance(double now) {
    if (current_ && now > current_->shownUntil) current_.reset();
}

}  // namespace timeshade
