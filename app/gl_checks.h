#pragma once

#include <optional>

#include "gl/debug_log.h"

namespace timeshade {

/// With --gl-debug: fails the command if the driver complained of anything.
class DriverWatch {
  public:
    explicit DriverWatch(bool on);
    /// Throws Error with the number of complaints and the first of them.
    void requireSilence() const;

  private:
    std::optional<gl::DebugLog> log_;
};

}  // namespace timeshade
