#include "core/pause.h"

#include <utility>

namespace timeshade {

namespace {

thread_local PauseHook* hookOfThread = nullptr;
thread_local double paused = 0.0;

}  // namespace

PauseHook* exchangePauseHook(PauseHook* hook) { return std::exchange(hookOfThread, hook); }

PauseHook* pauseHook() { return hookOfThread; }

void pausePoint() {
    if (hookOfThread == nullptr || !hookOfThread->isDue()) return;
    PauseHook& hook = *hookOfThread;
    const NoPauses within;
    hook.pause();
}

void announceWork(const std::string& text) {
    if (hookOfThread == nullptr) return;
    PauseHook& hook = *hookOfThread;
    const NoPauses within;
    hook.announce(text);
}

double millisecondsPaused() { return paused; }

void countPause(double milliseconds) { paused += milliseconds; }

}  // namespace timeshade
