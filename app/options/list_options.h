#pragma once

namespace timeshade {

/// `timeshade list`: what there is to choose from.
struct ListOptions {
    bool devices = false;  ///< EGL devices instead of scenes and techniques
    bool json = false;
};

}  // namespace timeshade
