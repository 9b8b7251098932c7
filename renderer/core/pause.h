#pragma once

#include <string>

namespace timeshade {

/// Thrown out of a pause point: nobody wants the work any more. No std::exception, so that no handler of failures takes
/// it for one.
struct WorkCancelled {};

/// What is done at the points where long work can be left for a moment: a window draws itself there.
class PauseHook {
  public:
    virtual ~PauseHook() = default;
    /// Has the work gone on for long enough? Cheap.
    virtual bool isDue() const = 0;
    /// May throw WorkCancelled.
    virtual void pause() = 0;
    /// What comes next can't be left and may take long: "building shader shade". Says so, where it can.
    virtual void announce(const std::string& text) = 0;
};

/// The hook of this thread; null for none. The one before is given back.
PauseHook* exchangePauseHook(PauseHook* hook);
PauseHook* pauseHook();

/// Called by long work wherever it can be left. Without a hook nothing happens; results are the same with and without.
void pausePoint();

/// As PauseHook::announce, where there is a hook.
void announceWork(const std::string& text);

/// While it lives nothing pauses: for commands to a device that count all that it does.
class NoPauses {
  public:
    NoPauses() : hook_(exchangePauseHook(nullptr)) {}
    ~NoPauses() { exchangePauseHook(hook_); }
    NoPauses(const NoPauses&) = delete;
    NoPauses& operator=(const NoPauses&) = delete;

  private:
    PauseHook* hook_;
};

/// How long this thread has spent in pauses so far, as its hooks said: no part of what the work takes.
double millisecondsPaused();

/// A hook says what a pause took, also where it ended the work. It has the clock; what is drawn depends on none.
void countPause(double milliseconds);

}  // namespace timeshade
