#include <gtest/gtest.h>

#include "core/frame_caches.h"

namespace timeshade {
namespace {

struct Content {
    explicit Content(int value) : number(value) {}
    std::size_t bytes() const { return 100; }
    int number = 0;
};

struct OtherContent {
    std::size_t bytes() const { return 1; }
};

class FrameCachesTest : public testing::Test {
  protected:
    CacheEntry<Content>& entry() { return caches_.entry<Content>("a: content"); }
    FrameCaches caches_;
};

TEST_F(FrameCachesTest, HoldsTheContentOfItsKeyAlone) {
    EXPECT_FALSE(entry().holds(7));
    EXPECT_EQ(entry().get(1).number, 1);
    entry().setKey(7);
    EXPECT_TRUE(entry().holds(7));
    EXPECT_FALSE(entry().holds(8));
    EXPECT_EQ(entry().get(2).number, 1) << "it is made once";
}

TEST_F(FrameCachesTest, KeyZeroIsNeverReused) {
    entry().get(1);
    entry().setKey(0);
    EXPECT_FALSE(entry().holds(0));
    EXPECT_FALSE(entry().wantedAgain(0));
    EXPECT_FALSE(entry().wantedAgain(0));
}

TEST_F(FrameCachesTest, KnowsWhatWasWantedTheTimeBefore) {
    EXPECT_FALSE(entry().wantedAgain(7));
    EXPECT_TRUE(entry().wantedAgain(7));
    EXPECT_FALSE(entry().wantedAgain(8));
    EXPECT_FALSE(entry().wantedAgain(7));
}

TEST_F(FrameCachesTest, InvalidatingForgetsContentsKeysAndWants) {
    entry().get(1);
    entry().setKey(7);
    EXPECT_FALSE(entry().wantedAgain(7));
    caches_.invalidateAll();
    EXPECT_FALSE(entry().holds(7));
    EXPECT_FALSE(entry().wantedAgain(7));
    EXPECT_EQ(entry().find(), nullptr);
    EXPECT_EQ(caches_.bytes(""), 0u);
}

TEST_F(FrameCachesTest, DropsWhatAFrameHasNotUsed) {
    entry().get(1);
    entry().setKey(7);
    caches_.endFrame();
    EXPECT_EQ(caches_.bytes("a: "), 100u);
    EXPECT_EQ(caches_.bytes("b: "), 0u);
    EXPECT_TRUE(entry().holds(7));  // used
    caches_.endFrame();
    EXPECT_EQ(caches_.bytes("a: "), 100u);
    caches_.endFrame();
    EXPECT_EQ(caches_.bytes("a: "), 0u);
    EXPECT_FALSE(entry().holds(7));
}

TEST_F(FrameCachesTest, RefusesTwoTypesUnderOneName) {
    entry();
    EXPECT_THROW(caches_.entry<OtherContent>("a: content"), Error);
}

}  // namespace
}  // namespace timeshade
