#pragma once

#include <cstddef>
#include <exception>
#include <functional>

namespace timeshade {

/// Whoever asked for a scene no longer wants it.
class LoadingCancelled : public std::exception {
  public:
    const char* what() const noexcept override { return "loading was cancelled"; }
};

/// Where loading is: "geometry", 3 of 17 parts done. `whole` is 0 for a step that has no parts.
struct LoadingStep {
    const char* name = "";
    std::size_t done = 0, whole = 0;
};

/// Told before each step, by the thread that loads. May throw LoadingCancelled.
using LoadingWatch = std::function<void(const LoadingStep&)>;

}  // namespace timeshade
