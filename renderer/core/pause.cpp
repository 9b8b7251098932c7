#include "core/pause.h"

#include <utility>

namespace timeshade {

namespace {

using Clock = std::chrono::steady_clock;

thread_local PauseHook* hookOfThread = nullptr;
thread_local Clock::duration paused{};

/// Adds the time even where the pause ends the work.
struct PauseTime {
    Clock::time_point begin = Clock::now();
    ~PauseTime() { paused += Clock::now() - begin; }
};

}  // namespace

PauseHook* exchangePauseHook(PauseHook* hook) { return std::exchange(hookOfThread, hook); }

PauseHook* pauseHook() { return hookOfThread; }

void pausePoint() {
    if (hookOfThread == nullptr || !hookOfThread->isDue()) return;
    PauseHook& hook = *hookOfThread;
    const NoPauses within;
    const PauseTime time;
    hook.pause();
}

void announceWork(const std::string& text) {
    if (hookOfThread == nullptr) return;
    PauseHook& hook = *hookOfThread;
    const NoPauses within;
    const PauseTime time;
    hook.announce(text);
}

Clock::duration timePaused() { return paused; }

}  // namespace timeshade
