// What a position sees when, of triangles that are chosen to be awkward: in one plane, edge-on, without area, through
// the eye, tiny, huge, touching; against the oracle's exact test of instants. With TIMESHADE_MANY set: five million.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

#include "oracle/resolve_primary.h"
#include "oracle/seen_segments.h"
#include "support/awkward_numbers.h"

namespace timeshade {
namespace {

using glm::dvec3;
using glm::vec3;
using oracle::MovingTriangles;
using oracle::PositionRay;
using oracle::SweptBvh;

long scenes(long usual) { return std::getenv("TIMESHADE_MANY") != nullptr ? 5000000 : usual; }

struct AwkwardScene {
    std::vector<glm::vec4> texels;
    PositionRay ray;

    void add(const vec3 (&open)[3], const vec3 (&close)[3], bool twoSided) {
        float values[4 * TRIANGLE_POSITION_TEXELS]{};
        for (int v = 0; v < 3; ++v)
            for (int c = 0; c < 3; ++c) {
                values[3 * v + c] = open[v][c];
                values[9 + 3 * v + c] = close[v][c];
            }
        values[18] = twoSided ? 1.0f : 0.0f;
        for (int i = 0; i < TRIANGLE_POSITION_TEXELS; ++i)
            texels.emplace_back(values[4 * i], values[4 * i + 1], values[4 * i + 2], values[4 * i + 3]);
    }
    AwkwardScene reversed() const {
        AwkwardScene other = *this;
        std::swap(other.ray.eye[0], other.ray.eye[1]);
        std::swap(other.ray.direction[0], other.ray.direction[1]);
        for (std::size_t t = 0; t < texels.size(); t += TRIANGLE_POSITION_TEXELS) {
            float* values = &other.texels[t].x;
            std::swap_ranges(values, values + 9, values + 9);
        }
        return other;
    }
};

AwkwardScene awkwardScene(AwkwardNumbers& numbers) {
    AwkwardScene s;
    const bool still = numbers.oneIn(2);
    s.ray.direction[0] = dvec3(numbers.between(-0.3f, 0.3f), numbers.between(-0.3f, 0.3f), 1.0f);
    s.ray.direction[1] = still ? s.ray.direction[0] : s.ray.direction[0] + 0.2 * dvec3(numbers.point());
    s.ray.eye[0] = dvec3(numbers.point());
    s.ray.eye[1] = still ? s.ray.eye[0] : s.ray.eye[0] + 0.3 * dvec3(numbers.point());
    s.ray.nearDistance = numbers.oneIn(2) ? 0.01 : 0.5;
    for (std::uint32_t count = 1 + numbers.below(4), i = 0; i < count; ++i) {
        // As a receiver at the eye sees them: the line is that of the ray, but for some.
        SegmentAndTriangle a = awkwardSegmentAndTriangle(numbers), b = awkwardSegmentAndTriangle(numbers);
        const vec3 eye[2] = {vec3(s.ray.eye[0]), vec3(s.ray.eye[1])};
        const bool toRay = !numbers.oneIn(3);
        vec3 open[3], close[3];
        for (int v = 0; v < 3; ++v) {
            // Around the ray, so that most are met.
            const vec3 along = toRay ? vec3(s.ray.direction[0]) * numbers.between(1.0f, 4.0f) : vec3(0.0f);
            open[v] = eye[0] + along + a.v[v];
            close[v] = numbers.oneIn(4) ? open[v] : eye[1] + along + b.v[v];
        }
        if (i > 0 && numbers.oneIn(3)) {  // a neighbour of the one before, or one in its plane
            const float* before = &s.texels[s.texels.size() - TRIANGLE_POSITION_TEXELS].x;
            for (int v = 0; v < 2; ++v) {
                const int from = 3 * (2 - v);
                open[v] = {before[from], before[from + 1], before[from + 2]};
                close[v] = {before[9 + from], before[10 + from], before[11 + from]};
            }
            if (numbers.oneIn(2)) {
                open[2] = {before[0], before[1], before[2]}, close[2] = {before[9], before[10], before[11]};
                open[2] = open[2] * 0.25f + open[0] * 0.5f + open[1] * 0.25f;
                close[2] = close[2] * 0.25f + close[0] * 0.5f + close[1] * 0.25f;
            }
        }
        s.add(open, close, numbers.oneIn(2));
    }
    return s;
}

bool isPartition(const std::vector<SeenSegment>& seen) {
    if (seen.empty() || seen.front().u0 != 0.0 || seen.back().u1 != 1.0) return false;
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i].u1 - seen[i].u0 < 0x1p-40 ||
            (i > 0 && (seen[i].u0 != seen[i - 1].u1 || seen[i].triangle == seen[i - 1].triangle)))
            return false;
    return true;
}

std::uint32_t seenAt(const std::vector<SeenSegment>& seen, double u) {
    return std::find_if(seen.begin(), seen.end(), [&](const SeenSegment& s) { return u <= s.u1; })->triangle;
}

struct Tally {
    std::atomic<long> instants{0}, hits{0}, margins{0}, segments{0}, changes{0}, partitions{0}, wrong{0}, reversed{0};
};

void check(AwkwardNumbers& numbers, Tally& tally) {
    const AwkwardScene scene = awkwardScene(numbers), back = scene.reversed();
    const MovingTriangles triangles(scene.texels), backTriangles(back.texels);
    const SweptBvh bvh(triangles), backBvh(backTriangles);
    const std::vector<SeenSegment> seen = oracle::seenSegments(scene.ray, triangles, bvh);
    const std::vector<SeenSegment> mirrored = oracle::seenSegments(back.ray, backTriangles, backBvh);
    tally.segments += static_cast<long>(seen.size());
    tally.changes += seen.size() > 1 ? 1 : 0;
    tally.partitions += isPartition(seen) ? 1 : 0;
    for (int i = 0; i < 8; ++i) {
        const auto u = static_cast<double>(numbers.unit());
        const bool nearChange =
            std::any_of(seen.begin(), seen.end(), [&](const SeenSegment& s) { return std::abs(u - s.u0) < 1e-9; });
        if (nearChange) continue;
        const Oracle::ResolvedPrimary truth =
            oracle::resolveFirstSeen(bvh, triangles, oracle::rayAt(scene.ray, u), scene.ray.nearDistance);
        ++tally.instants;
        tally.margins += truth.marginal ? 1 : 0;
        if (truth.marginal) continue;
        tally.hits += truth.triangle != NO_TRIANGLE ? 1 : 0;
        tally.wrong += seenAt(seen, u) != truth.triangle ? 1 : 0;
        tally.reversed += seenAt(mirrored, 1.0 - u) != truth.triangle ? 1 : 0;
    }
}

TEST(SegmentProperties, AwkwardTrianglesAreSeenAsTheirInstantsAre) {
    const long count = scenes(40000);
    Tally tally;
    std::thread threads[2];
    for (std::uint32_t t = 0; t < 2; ++t)
        threads[t] = std::thread([&, t] {
            AwkwardNumbers numbers(40 + t);
            for (long i = 0; i < count / 2; ++i) check(numbers, tally);
        });
    for (std::thread& thread : threads) thread.join();
    std::printf(
        "%ld scenes, %ld segments, %ld with changes; %ld instants, %ld of them within rounding, %ld see a triangle\n",
        count, tally.segments.load(), tally.changes.load(), tally.instants.load(), tally.margins.load(),
        tally.hits.load());
    EXPECT_EQ(tally.partitions, count);
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_EQ(tally.reversed, 0);
    EXPECT_GT(tally.changes, count / 4);
    EXPECT_GT(tally.hits, tally.instants / 8);
    EXPECT_LT(tally.margins, tally.instants / 2);
}

}  // namespace
}  // namespace timeshade
