#include "core/check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace timeshade {
namespace {

enum class Colour { Red = 3 };
struct Opaque {
    bool operator==(const Opaque&) const { return false; }
};

TEST(Check, PassesSilently) {
    CHECK(1 + 1 == 2);
    CHECK_EQ(2, 2u);
    CHECK_NE(std::string("a"), "b");
    CHECK_LT(-1, 0u);  // by value: in C++'s own comparison -1 would be the largest
    CHECK_LE(0.5, 0.5);
    CHECK_GT(std::numeric_limits<std::size_t>::max(), -1);
    CHECK_GE('b', 'a');
    CHECK_EQ(Colour::Red, Colour::Red);
}

TEST(Check, EvaluatesItsArgumentsOnce) {
    int calls = 0;
    const auto next = [&] { return ++calls; };
    CHECK_EQ(next(), 1);
    CHECK(next() == 2);
    EXPECT_EQ(calls, 2);
}

TEST(Check, IsOneStatement) {
    bool reached = false;
    if (!reached)
        CHECK(true);
    else
        CHECK_EQ(1, 2);
    reached = true;
    EXPECT_TRUE(reached);
}

TEST(CheckDeathTest, PrintsExpressionValuesFileAndLine) {
    const int index = 7, count = 3;
    EXPECT_DEATH(CHECK_LT(index, count), "check_test.cpp:[0-9]+: check failed: index < count \\(7 and 3\\)");
    EXPECT_DEATH(CHECK(index == count), "check_test.cpp:[0-9]+: check failed: index == count \\(false\\)");
}

TEST(CheckDeathTest, EveryComparisonFailsWhereItShould) {
    EXPECT_DEATH(CHECK_EQ(1, 2), "1 == 2 \\(1 and 2\\)");
    EXPECT_DEATH(CHECK_NE(2, 2), "2 != 2 \\(2 and 2\\)");
    EXPECT_DEATH(CHECK_LT(2, 2), "2 < 2");
    EXPECT_DEATH(CHECK_LE(3, 2), "3 <= 2");
    EXPECT_DEATH(CHECK_GT(2, 2), "2 > 2");
    EXPECT_DEATH(CHECK_GE(-1, 0u), "-1 >= 0u \\(-1 and 0\\)");
}

TEST(CheckDeathTest, NotANumberSatisfiesNoOrder) {
    const double nothing = std::nan("");
    EXPECT_DEATH(CHECK_LE(nothing, 1.0), "nothing <= 1.0 \\(nan and 1\\)");
    EXPECT_DEATH(CHECK_GE(nothing, 1.0), "nothing >= 1.0");
    EXPECT_DEATH(CHECK_EQ(nothing, nothing), "nan and nan");
}

TEST(CheckDeathTest, PrintsTextEnumeratorsAndOtherTypes) {
    EXPECT_DEATH(CHECK_EQ(std::string("left"), "right"), "left and right");
    EXPECT_DEATH(CHECK_NE(Colour::Red, Colour::Red), "3 and 3");
    EXPECT_DEATH(CHECK_EQ(Opaque{}, Opaque{}), "\\? and \\?");
}

}  // namespace
}  // namespace timeshade
