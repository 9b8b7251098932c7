#include "core/memory_budget.h"

#include <string>

#include <gtest/gtest.h>

#include "../broken_gltf/gltf_writer.h"
#include "core/error.h"
#include "scene/gltf_scene.h"

namespace timeshade {
namespace {

constexpr std::uint64_t mebibyte = 1 << 20;

std::string refusal(MemoryBudget& budget, std::uint64_t times, std::uint64_t each) {
    try {
        budget.take(times, each, "the keys");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(MemoryBudget, CountsUpToItsLimit) {
    MemoryBudget budget(10 * mebibyte);
    EXPECT_EQ(refusal(budget, 6, mebibyte), "");
    EXPECT_EQ(budget.left(), 4 * mebibyte);
    EXPECT_EQ(refusal(budget, 5, mebibyte),
              "no room for the keys (5.0 MiB): of the 10.0 MiB that a scene may take (--memory-limit) 4.0 are left");
    EXPECT_EQ(budget.left(), 4 * mebibyte) << "what is refused does not count";
    EXPECT_EQ(refusal(budget, 4 * mebibyte, 1), "");
    EXPECT_EQ(refusal(budget, 0, mebibyte), "");
    EXPECT_EQ(refusal(budget, mebibyte, 0), "");
    EXPECT_NE(refusal(budget, 1, 1), "");
}

TEST(MemoryBudget, ProductsThatNoNumberHoldsAreRefused) {
    MemoryBudget budget(10 * mebibyte);
    EXPECT_NE(refusal(budget, std::uint64_t{1} << 40, std::uint64_t{1} << 40), "");
    EXPECT_NE(refusal(budget, 3, std::uint64_t{1} << 63), "");
    EXPECT_EQ(budget.left(), 10 * mebibyte);
}

TEST(MemoryBudget, IsAtLeastSomethingByDefault) {
    EXPECT_GE(quarterOfMemory(), 256 * mebibyte);
    MemoryBudget without;
    EXPECT_EQ(refusal(without, std::uint64_t{1} << 30, std::uint64_t{1} << 30), "");
}

/// A scene is read with any limit or refused, and never the one with less and the other with more.
TEST(MemoryBudget, OfASceneHasOneThreshold) {
    const test::TemporaryFolder folder;
    const auto path = folder.write("m.glb", test::fileWithEverything().glb());
    const auto fits = [&](std::uint64_t limit) {
        try {
            loadGltf(path, {.memoryLimit = limit});
            return true;
        } catch (const Error&) {
            return false;
        }
    };
    bool before = false;
    for (std::uint64_t limit = 1 << 10; limit <= 16 * mebibyte; limit += limit / 4) {
        const bool now = fits(limit);
        EXPECT_TRUE(now || !before) << limit;
        before = now;
    }
    EXPECT_TRUE(before);
    EXPECT_FALSE(fits(1 << 10));
}

}  // namespace
}  // namespace timeshade
