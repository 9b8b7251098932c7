#pragma once

namespace timeshade {

/// How two pictures of one moment become one.
enum class CompareMode {
    Wipe,        ///< the first left of a seam, the second right of it
    Side,        ///< the central half of each, side by side
    Difference,  ///< how far apart they are, some times as bright
};

}  // namespace timeshade
