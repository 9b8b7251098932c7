// Lists of intervals: what arranging them may change, and what it may not, on lists of every kind.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "shared/map_interval.shared.h"

namespace timeshade::shared {
namespace {

std::vector<MapInterval> list;

MapInterval loadInterval(std::uint32_t place) { return list.at(place); }
float loadBegin(std::uint32_t place) { return list.at(place).begin; }
void storeInterval(std::uint32_t place, const MapInterval& i) { list.at(place) = i; }

}  // namespace
}  // namespace timeshade::shared

#include "shared/interval_list.shared.h"

namespace timeshade {
namespace {

using shared::MapInterval;
using List = std::vector<MapInterval>;

constexpr double nothing = 1e9;

double depthAt(const MapInterval& i, double u) {
    const auto begin = static_cast<double>(i.begin), end = static_cast<double>(i.end);
    return glm::mix(static_cast<double>(i.depthBegin), static_cast<double>(i.depthEnd), (u - begin) / (end - begin));
}

double nearestAt(const List& intervals, double u) {
    double nearest = nothing;
    for (const MapInterval& i : intervals)
        if (u >= static_cast<double>(i.begin) && u <= static_cast<double>(i.end))
            nearest = std::min(nearest, depthAt(i, u));
    return nearest;
}

std::uint32_t sizeOf(const List& intervals) { return static_cast<std::uint32_t>(intervals.size()); }

std::size_t keptOf(const List& intervals) {
    return static_cast<std::size_t>(
        std::count_if(intervals.begin(), intervals.end(), [](const MapInterval& i) { return i.begin < 1.5f; }));
}

/// Short and long, apart and in a row, in few distances or many, that cross or are equal.
List randomList(std::mt19937& random) {
    const auto number = [&](double low, double high) {
        return static_cast<float>(std::uniform_real_distribution(low, high)(random));
    };
    const std::size_t count = 1 + random() % 24;
    const bool coarse = random() % 3 == 0;  // times and distances that are often equal
    const auto rounded = [&](float x) { return coarse ? std::round(x * 8.0f) / 8.0f : x; };
    List intervals;
    for (std::uint32_t i = 0; intervals.size() < count; ++i) {
        const float begin = rounded(number(0, 1)),
                    end = std::min(1.0f, rounded(begin + number(0, random() % 2 ? 1 : 0.2)));
        if (begin < end) intervals.push_back({begin, end, rounded(number(3, 9)), rounded(number(3, 9)), i / 2});
    }
    std::shuffle(intervals.begin(), intervals.end(), random);
    return intervals;
}

List inOrder(const List& intervals, bool asDrawn) {
    shared::list = intervals;
    List ordered(intervals.size());
    for (std::uint32_t place = 0; place < sizeOf(intervals); ++place)
        ordered[asDrawn ? shared::rankAsDrawn(0, sizeOf(intervals), place)
                        : shared::rankByTime(0, sizeOf(intervals), place)] = intervals[place];
    return ordered;
}

List visibleOf(List intervals) {
    shared::list = std::move(intervals);
    List visible;
    for (std::uint32_t place = 0; place < sizeOf(shared::list); ++place)
        visible.push_back(shared::visiblePart(0, sizeOf(shared::list), place));
    return inOrder(visible, false);
}

struct Compressed {
    List list;
    double error;
};

/// `step`: intervals at a time.
Compressed compressedOf(const List& intervals, std::uint32_t capacity, std::uint32_t step = 1000) {
    shared::list = inOrder(intervals, true);
    float error = 0.0f;
    const std::uint32_t count = sizeOf(intervals);
    for (std::uint32_t from = 0; from < count; from += step)
        error += shared::compressIntervals(0, from, std::min(count, from + step), capacity);
    return {shared::list, static_cast<double>(error)};
}

bool isSorted(const List& intervals) {
    return std::is_sorted(intervals.begin(), intervals.end(),
                          [](const MapInterval& a, const MapInterval& b) { return a.begin < b.begin; });
}

bool sameLists(const List& a, const List& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const MapInterval& x, const MapInterval& y) {
        return x.begin == y.begin && x.end == y.end && x.depthBegin == y.depthBegin && x.depthEnd == y.depthEnd &&
               x.id == y.id;
    });
}

/// Times that are no end of an interval.
constexpr int instants = 997;
double instant(int i) { return (i + 0.5) / instants; }

TEST(MapInterval, WhatIsSeenStaysWhatItWas) {
    std::mt19937 random(2011);
    std::size_t before = 0, after = 0;
    for (int round = 0; round < 3000; ++round) {
        const List intervals = randomList(random);
        const List visible = visibleOf(intervals);
        ASSERT_TRUE(isSorted(visible));
        before += intervals.size();
        after += keptOf(visible);
        for (int i = 0; i < instants; ++i) {
            const double u = instant(i), is = nearestAt(visible, u), was = nearestAt(intervals, u);
            // Where two of them cross, at a time that is rounded, the farther is seen a moment longer.
            ASSERT_NEAR(is, was, 2e-5) << "round " << round << ", u " << u;
        }
    }
    EXPECT_LT(after, before * 2 / 3) << "little is hidden, so the test shows little";
}

TEST(MapInterval, WhatIsAsFarAwayHidesNothing) {
    const MapInterval one{0.25f, 0.75f, 4.0f, 5.0f, 7};
    MapInterval two = one, three = one;
    two.depthBegin = 4.000001f;
    three.depthEnd = 4.999999f;
    EXPECT_EQ(keptOf(visibleOf({one, two, three, one})), 4u);
}

TEST(MapInterval, ARowOfNearerOnesHidesWhatNoneHidesAlone) {
    const MapInterval behind{0.1f, 0.9f, 8.0f, 8.0f, 0};
    const List visible =
        visibleOf({behind, {0.0f, 0.4f, 5.0f, 5.0f, 1}, {0.4f, 0.7f, 5.0f, 5.0f, 2}, {0.7f, 1.0f, 5.0f, 5.0f, 3}});
    EXPECT_EQ(keptOf(visible), 3u);
}

TEST(MapInterval, NoOrderOfAListMatters) {
    std::mt19937 random(1);
    for (int round = 0; round < 500; ++round) {
        List intervals = randomList(random);
        const List visible = visibleOf(intervals), compressed = compressedOf(intervals, 4).list;
        std::shuffle(intervals.begin(), intervals.end(), random);
        ASSERT_TRUE(sameLists(visible, visibleOf(intervals)));
        ASSERT_TRUE(sameLists(compressed, compressedOf(intervals, 4, 3).list)) << "some at a time";
        ASSERT_TRUE(sameLists(compressed, compressedOf(intervals, 4).list));
    }
}

TEST(MapInterval, CompressionIsAsFarOffAsItSaysAtMost) {
    std::mt19937 random(2010);
    double most = 0.0;
    for (int round = 0; round < 2000; ++round) {
        const List intervals = randomList(random);
        const std::uint32_t capacity = 1 + static_cast<std::uint32_t>(random() % 8);
        const Compressed compressed = compressedOf(intervals, capacity);
        ASSERT_TRUE(isSorted(compressed.list));
        ASSERT_LE(keptOf(compressed.list), capacity);
        if (intervals.size() <= capacity) {
            ASSERT_EQ(compressed.error, 0.0);
        }
        double area = 0.0;
        for (int i = 0; i < instants; ++i) {
            const double is = nearestAt(compressed.list, instant(i)), was = nearestAt(intervals, instant(i));
            ASSERT_FALSE(is == nothing && was != nothing) << "a caster is lost";
            area += (was == nothing ? (is == nothing ? 0.0 : is) : std::abs(is - was)) / instants;
        }
        ASSERT_LE(area, compressed.error * 1.0001 + 0.02) << "round " << round;  // of the sum over instants
        if (compressed.error > 0.0) most = std::max(most, area / compressed.error);
    }
    EXPECT_GT(most, 0.5) << "the bound is far off, so the test shows little";
}

TEST(MapInterval, MergingCostsTheAreaBetween) {
    const MapInterval a{0.0f, 0.5f, 4.0f, 4.0f, 1}, b{0.5f, 1.0f, 4.0f, 4.0f, 1}, far{0.0f, 1.0f, 8.0f, 8.0f, 2};
    EXPECT_EQ(shared::mergingError(a, b), 0.0f);
    EXPECT_EQ(shared::mergedOf(a, b).id, 1u);
    // 4 until .5 and 8 from there on; merged it rises from 4 to 8 all through: two triangles of .5 x 2.
    EXPECT_NEAR(shared::mergingError(a, far), 1.0f, 1e-6f);
    EXPECT_EQ(shared::mergedOf(a, far).id, NO_INTERVAL_ID);
    // A gap of a quarter, at a distance of 4.
    EXPECT_NEAR(shared::mergingError(a, {0.75f, 1.0f, 4.0f, 4.0f, 3}), 1.0f, 1e-6f);
    // Two that cross at a half: 4 to 8 and 8 to 4; merged it is 4 all through. Two triangles of .5 x 2.
    EXPECT_NEAR(shared::mergingError({0.0f, 1.0f, 4.0f, 8.0f, 1}, {0.0f, 1.0f, 8.0f, 4.0f, 2}), 1.0f, 1e-6f);
}

}  // namespace
}  // namespace timeshade
