#pragma once

#include <string>
#include <vector>

#include "window/shader_watch.h"

namespace timeshade {

/// Whether the programs are as their files say.
struct ShaderState {
    ShaderWatch watch;
    std::vector<std::string> log;  ///< empty while all are; the last good programs stay in use
    int number = 0;                ///< changes with the programs
};

}  // namespace timeshade
