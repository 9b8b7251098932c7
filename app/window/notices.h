#pragma once

#include <optional>
#include <string>

namespace timeshade {

/// A line that is shown over the picture for a few seconds. The newest replaces the one before.
class Notices {
  public:
    struct Notice {
        std::string text;
        bool bad = false;
        double shownUntil = 0.0;  ///< seconds of the window's clock
    };

    /// `now` in seconds of the window's clock. What went wrong is shown longer.
    void show(std::string text, bool bad, double now);
    void advance(double now);
    void close() { current_.reset(); }
    const std::optional<Notice>& current() const { return current_; }

  private:
    std::optional<Notice> current_;
};

}  // namespace timeshade
