#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/error.h"
#include "core/one_line.h"

namespace timeshade::fuzz {

/// A reader takes what it is given or refuses it with an Error of one line; any other exception ends the target, as
/// does a line that a terminal would not show as it is.
template <typename Reader>
void readOrRefused(Reader&& read) {
    try {
        read();
    } catch (const Error& error) {
        const std::string line = error.what();
        if (!line.empty() && line == oneLine(line, line.size())) return;
        std::fprintf(stderr, "a refusal that is not one line of text: %s\n", line.c_str());
        std::abort();
    }
}

}  // namespace timeshade::fuzz
