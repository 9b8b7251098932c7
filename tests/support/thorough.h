#pragma once

#include <cstddef>
#include <cstdlib>
#include <string_view>

namespace timeshade {

/// Of what a test draws at random, how much: `usual` of it in ./test, `all` where the environment says
/// TIMESHADE_TESTS=thorough, as .ci/run does. What is allowed is the same in both.
template <typename Count>
Count usualOrAll(Count usual, Count all) {
    const char* const wanted = std::getenv("TIMESHADE_TESTS");
    return wanted != nullptr && std::string_view(wanted) == "thorough" ? all : usual;
}

/// Of what a test counts, as a rule one of so many; all in thorough tests.
inline bool isDrawn(std::size_t number, std::size_t of = 3) { return number % usualOrAll<std::size_t>(of, 1) == 0; }

}  // namespace timeshade
