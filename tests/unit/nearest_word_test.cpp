// What was meant by a misspelt word.
#include <gtest/gtest.h>

#include "core/nearest_word.h"

namespace timeshade {
namespace {

const std::vector<std::string> names{"steady", "tin", "interlaced", "interfaces", "interval", "precise", "temperate"};

TEST(NearestWord, IsAFewLettersAway) {
    EXPECT_EQ(nearestWord("precisse", names), "precise");  // one too many
    EXPECT_EQ(nearestWord("precse", names), "precise");    // one too few
    EXPECT_EQ(nearestWord("preicse", names), "precise");   // swapped
    EXPECT_EQ(nearestWord("PRECISE", names), "precise");   // capitals
    EXPECT_EQ(nearestWord("tni", names), "tin");           // three letters, one change
    EXPECT_EQ(nearestWord("intervalls", names), "interval");
    EXPECT_EQ(nearestWord("interface", names), "interfaces");
    EXPECT_EQ(nearestWord("temp", names), "temperate");  // only one begins like that
}

TEST(NearestWord, IsNoneWhereNothingIsNear) {
    EXPECT_FALSE(nearestWord("", names));
    EXPECT_FALSE(nearestWord("nonsense", names));
    EXPECT_FALSE(nearestWord("int", names)) << "three begin like that";
    EXPECT_FALSE(nearestWord("t", names));
    EXPECT_FALSE(nearestWord("xyz", names)) << "as many changes as letters";
    EXPECT_FALSE(nearestWord("precise", names)) << "it is one";
    EXPECT_FALSE(nearestWord(std::string(100000, 'e'), names));
}

TEST(NearestWord, IsAQuestion) {
    EXPECT_EQ(didYouMean("prcise", names), " (did you mean precise?)");
    EXPECT_EQ(didYouMean("nonsense", names), "");
}

}  // namespace
}  // namespace timeshade
