#pragma once

#include <cstddef>
#include <cstdlib>
#include <string_view>

namespace timeshade {

/// How much of what a test draws at random or counts is drawn: the environment's TIMESHADE_TESTS. What is allowed is
/// the same in all.
enum class TestedShare {
    Usual,     ///< as in ./test
    Thorough,  ///< "thorough", as .ci/run has it: several times as much
    All        ///< "all": every combination
};

inline TestedShare testedShare() {
    const char* const text = std::getenv("TIMESHADE_TESTS");
    const std::string_view wanted = text != nullptr ? text : "";
    return wanted == "all" ? TestedShare::All : wanted == "thorough" ? TestedShare::Thorough : TestedShare::Usual;
}

/// `usual` in ./test, `all` in thorough tests.
template <typename Count>
Count usualOrAll(Count usual, Count all) {
    return testedShare() == TestedShare::Usual ? usual : all;
}

/// Of what a test counts, as a rule one of so many; in thorough tests every second one.
inline bool isDrawn(std::size_t number, std::size_t of = 3) {
    const TestedShare share = testedShare();
    return share == TestedShare::All || number % (share == TestedShare::Thorough ? 2 : of) == 0;
}

}  // namespace timeshade
