#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "gl/buffer.h"
#include "gl/foreseen_count.h"
#include "gl/late_counts.h"

namespace timeshade::gl {

/// A draw that fills a list and counts what should be in it, at the first place of a buffer.
struct CountedDraw {
    const Buffer& counts;
    std::shared_ptr<ForeseenCount> foreseen;
    std::size_t before = 0;  ///< how many there were; 0: not known
    MakeRoom makeRoom;
    std::function<void(std::size_t room)> draw;
};

/// Draws with room for as many as there were, and again where there were more. Where counts are read later, once, with
/// room for a few more than there were. Returns how many there are at most.
std::size_t drawCounted(LateCounts& late, const CountedDraw& counted);

}  // namespace timeshade::gl
