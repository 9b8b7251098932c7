#pragma once

#include <array>
#include <optional>
#include <string>

#include "plan/frame_request.h"

namespace timeshade {

/// How much less is drawn while something moves, so that a frame takes at most about 100 ms. Level 0 is everything;
/// the levels above it draw fewer pixels, and where that is not enough, fewer samples; last of all a smaller map, since
/// that changes what there is to be seen.
class PreviewQuality {
  public:
    static constexpr double slowMilliseconds = 100.0;
    static constexpr int levels = 10;

    enum class Choice {
        Full,       ///< all of it, always: a frame takes as long as it takes
        Automatic,  ///< as much as there is time for
        Coarse      ///< at most a quarter of the picture's sides, at once
    };
    void setChoice(Choice choice) { choice_ = choice; }

    static constexpr int firstOnSoftware = 6;

    /// A first guess before anything has been measured.
    explicit PreviewQuality(bool software) : level_(software ? firstOnSoftware : 0) {}

    int level() const;
    FrameRequest reduced(FrameRequest full, int level) const;

    /// A frame of that level took so long. Chooses the level of the next.
    void measured(int level, double milliseconds);
    /// Another technique or scene: what was measured says nothing any more.
    void forget();

  private:
    Choice choice_ = Choice::Automatic;
    int level_;
    int fastFrames_ = 0;  ///< in a row, at this level
    std::array<std::optional<double>, levels> cost_{};
};

/// "automatic"
std::string nameOf(PreviewQuality::Choice choice);
/// Nothing where there is none of that name.
std::optional<PreviewQuality::Choice> previewOf(const std::string& name);

}  // namespace timeshade
