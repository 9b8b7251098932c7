#pragma once

#include <cstddef>
#include <vector>

#include "window/shown_picture.h"

namespace timeshade {

/// What the last pictures took, for a graph. Oldest first.
class FrameGraph {
  public:
    static constexpr std::size_t kept = 120;

    struct Bar {
        float milliseconds = 0.0f;
        bool preview = false;
    };
    /// To be called on every frame of the window: a picture that is whole is noted once.
    void note(const ShownPicture& shown);
    const std::vector<Bar>& bars() const { return bars_; }

  private:
    std::vector<Bar> bars_;
    int lastNumber_ = 0;
};

}  // namespace timeshade
