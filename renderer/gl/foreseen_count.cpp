#include "gl/foreseen_count.h"

#include <algorithm>

#include "core/check.h"
#include "core/error.h"

namespace timeshade::gl {

void ForeseenCount::note(std::size_t found) {
    const std::size_t before = lately_.value_or(0);
    lately_ = std::max(found, before - before / 8);
}

std::size_t ForeseenCount::makeRoom(const MakeRoom& make) {
    CHECK(known());
    const bool spare = *lately_ + *lately_ / 8 + 256 <= room_;
    try {
        room_ = make(spare ? *lately_ : *lately_ + *lately_ / 2 + 1024);
    } catch (const LimitError&) {
        room_ = make(*lately_);  // what was there fits
    }
    return room_;
}

}  // namespace timeshade::gl
