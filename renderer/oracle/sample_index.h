#pragma once

#include <cstdint>

namespace timeshade {

/// A camera sample: which pixel (x to the right, y upwards from the bottom row) and which stratum.
struct SampleIndex {
    std::uint32_t x = 0, y = 0, stratum = 0;
};

}  // namespace timeshade
