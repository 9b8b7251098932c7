#pragma once

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "support/thorough.h"

namespace timeshade {

/// For the begin of a test in a suite with values: whether it is drawn for its value. As a rule for about every third,
/// others in another test; for all where TIMESHADE_TESTS=thorough. By the names alone (FNV-1a): one more scene or
/// technique decides nothing about the others.
inline bool isDrawnHere() {
    std::uint32_t hash = 2166136261u;
    for (const char* c = testing::UnitTest::GetInstance()->current_test_info()->name(); *c != '\0'; ++c)
        hash = (hash ^ static_cast<unsigned char>(*c)) * 16777619u;
    return isDrawn(hash >> 8);
}

}  // namespace timeshade

/// Ends the test where it is not drawn.
#define TIMESHADE_DRAWN_HERE() \
    if (!::timeshade::isDrawnHere()) GTEST_SKIP() << "drawn where TIMESHADE_TESTS=thorough"
