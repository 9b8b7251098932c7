#pragma once

#include <array>
#include <optional>

#include "plan/frame_request.h"

namespace timeshade {

/// How much less is drawn while something moves, so that a frame takes at most about 100 ms. Level 0 is everything;
/// the levels above it draw fewer pixels, and where that is not enough, fewer samples and a smaller map.
class PreviewQuality {
  public:
    static constexpr double slowMilliseconds = 100.0;
    static constexpr int levels = 8;

    /// A first guess before anything has been measured.
    explicit PreviewQuality(bool software) : level_(software ? 5 : 0) {}

    int level() const { return level_; }
    FrameRequest reduced(FrameRequest full, int level) const;

    /// A frame of that level took so long. Chooses the level of the next.
    void measured(int level, double milliseconds);
    /// Another technique or scene: what was measured says nothing any more.
    void forget();

  private:
    int level_;
    int fastFrames_ = 0;  ///< in a row, at this level
    std::array<std::optional<double>, levels> cost_{};
};

}  // namespace timeshade
