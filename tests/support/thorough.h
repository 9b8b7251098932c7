#pragma once

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

/// Why a test is skipped otherwise.
constexpr const char* drawnInThoroughTests = "drawn where TIMESHADE_TESTS=thorough";

}  // namespace timeshade
