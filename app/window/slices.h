#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <utility>

#include "core/pause.h"

namespace timeshade {

/// Keeps a window alive while something long is drawn or found out: that is cut into slices of about 20 ms at its pause
/// points, and the window draws itself, and hears its user, after each. Work that is no longer wanted ends with the
/// slice.
class Slices final : public PauseHook {
  public:
    /// `drawWindow` draws a frame of the window and takes its input.
    Slices(std::function<void()> drawWindow, std::function<bool()> isUnwanted,
           std::chrono::milliseconds length = std::chrono::milliseconds(20))
        : drawWindow_(std::move(drawWindow)), isUnwanted_(std::move(isUnwanted)), length_(length) {}

    /// While it lives, this thread's work is cut into slices.
    class Work {
      public:
        explicit Work(Slices& slices);
        ~Work();
        Work(const Work&) = delete;
        Work& operator=(const Work&) = delete;

      private:
        Slices& slices_;
        PauseHook* before_;
    };

    bool isDue() const override;
    void pause() override;
    void announce(const std::string& text) override;

    /// Slices that have ended at a pause point since the start, and how many of these ended the work.
    int ended() const { return ended_; }
    int cancelled() const { return cancelled_; }
    /// What can't be left just now: "building shader shade"; empty for nothing.
    const std::string& announced() const { return announced_; }

  private:
    void drawWindow();

    std::function<void()> drawWindow_;
    std::function<bool()> isUnwanted_;
    std::chrono::milliseconds length_;
    std::chrono::steady_clock::time_point begin_;
    int ended_ = 0, cancelled_ = 0;
    std::string announced_;
};

}  // namespace timeshade
