// What the candidate lists rely on: a cell that a moving triangle covers anywhere, at any time, is never left out, nor
// is a receiver behind it rejected by the packed bounds. Random and adversarial triangles, against double precision,
// point by point.
#include <set>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "shared/candidate_bounds.shared.h"

namespace timeshade {
namespace {

using glm::dvec3;
using glm::vec2;
using glm::vec3;

class CandidateBounds : public testing::Test {
  protected:
    double number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
    bool oneIn(int n) { return std::uniform_int_distribution(1, n)(random_) == 1; }

    vec3 vertex(vec3 around, double reach) {
        vec3 v = around + vec3(dvec3(number(-reach, reach), number(-reach, reach), number(-reach, reach)));
        if (oneIn(30)) v.z = static_cast<float>(number(-1.0, 0.2));
        if (oneIn(40)) v.x = 0.0f;
        return v;
    }
    dvec3 barycentrics() {
        dvec3 w(number(0.0, 1.0), number(0.0, 1.0), number(0.0, 1.0));
        for (int i = 0; i < 3; ++i)
            if (oneIn(3)) w[i] = 0.0;
        const double sum = w.x + w.y + w.z;
        return sum > 0.0 ? w / sum : dvec3(1.0, 0.0, 0.0);
    }

    std::mt19937 random_{20261123};
};

TEST_F(CandidateBounds, NoCoveredCellIsLeftOut) {
    int seen = 0, left = 0;
    for (int n = 0; n < 60000; ++n) {
        const bool perspective = oneIn(2);
        const double reach = oneIn(3) ? 0.6 : oneIn(2) ? 0.05 : 0.002;
        const vec3 around(dvec3(number(0.0, 1.0), number(0.0, 1.0), number(0.3, 1.5)));
        std::array<vec3, 3> a, b;
        const vec3 way =
            vec3(dvec3(number(-1.0, 1.0), number(-1.0, 1.0), number(-1.0, 1.0))) * static_cast<float>(reach);
        for (std::size_t i = 0; i < 3; ++i) {
            a[i] = vertex(around, reach);
            b[i] = oneIn(3) ? vertex(around, reach) : a[i] + way;
        }
        const auto flat = [&](vec3 v) { return perspective ? v : vec3(v.x, v.y, 1.0f); };
        const shared::EdgeSweep edges[3] = {shared::edgeSweep(flat(a[1]), flat(a[2]), flat(b[1]), flat(b[2])),
                                            shared::edgeSweep(flat(a[2]), flat(a[0]), flat(b[2]), flat(b[0])),
                                            shared::edgeSweep(flat(a[0]), flat(a[1]), flat(b[0]), flat(b[1]))};
        const int side = 1 << std::uniform_int_distribution(0, 10)(random_);
        for (int point = 0; point < 20; ++point) {
            const double u = oneIn(4) ? 0.0 : oneIn(4) ? 1.0 : number(0.0, 1.0);
            const dvec3 w = barycentrics();
            dvec3 p(0.0);
            for (std::size_t i = 0; i < 3; ++i)
                p += w[static_cast<int>(i)] * ((1.0 - u) * dvec3(a[i]) + u * dvec3(b[i]));
            if (perspective && p.z <= 1e-3) continue;
            const glm::dvec2 place = perspective ? glm::dvec2(p) / p.z : glm::dvec2(p);
            if (place.x < 0.0 || place.y < 0.0 || place.x >= 1.0 || place.y >= 1.0) continue;
            ++seen;
            const glm::ivec2 cell(place * static_cast<double>(side));
            const float width = 1.0f / static_cast<float>(side);
            ASSERT_FALSE(shared::missesSquare(edges[0], edges[1], edges[2], (vec2(cell) + 0.5f) * width,
                                              0.5f * width + MAP_POSITION_SLACK))
                << "triangle " << n << ", side " << side << ", u " << u;
            // A cell far off is left out often enough for the test to mean something.
            const vec2 elsewhere(dvec3(number(0.0, 1.0), number(0.0, 1.0), 0.0));
            left += shared::missesSquare(edges[0], edges[1], edges[2], elsewhere, 0.5f * width + MAP_POSITION_SLACK)
                        ? 1
                        : 0;
        }
    }
    EXPECT_GT(seen, 200000);
    EXPECT_GT(left, seen / 4);
}

TEST_F(CandidateBounds, PackedBoundsNeverRejectWhatTheyHold) {
    int away = 0;
    for (int n = 0; n < 200000; ++n) {
        const vec2 low(dvec3(number(-0.5, 1.2), number(-0.5, 1.2), 0.0));
        const vec2 high = low + vec2(dvec3(number(0.0, 1.5), number(0.0, 1.5), 0.0));
        const auto nearest = static_cast<float>(oneIn(20) ? number(-1.0, 0.0) : number(0.0, 100.0));
        const auto least = static_cast<float>(std::exp2(number(-20.0, 8.0)));
        const glm::uint packed = shared::packCandidateBounds(low, high, shared::depthStep(nearest, least));
        ASSERT_EQ(packed & CANDIDATE_GUARDS, 0u);
        // A receiver in this cell, inside the bounds, and no nearer to the light.
        const vec2 inside(dvec3(number(0.0, 1.0), number(0.0, 1.0), 0.0));
        const float depth =
            oneIn(3) ? std::max(nearest, 0.0f) : std::max(nearest, 0.0f) + static_cast<float>(number(0.0, 10.0));
        const bool reached =
            shared::candidateReaches(packed, shared::packReceiverPlace(inside, shared::depthStep(depth, least)));
        if (inside.x >= low.x && inside.y >= low.y && inside.x <= high.x && inside.y <= high.y) {
            ASSERT_TRUE(reached) << n;
        }
        away += reached ? 0 : 1;
        // Without the depth: the fields compared one by one.
        const auto sixteenth = [](float x) { return glm::clamp(static_cast<int>(std::floor(x * 16.0f)), 0, 15); };
        const bool within = sixteenth(inside.x) >= sixteenth(low.x) && sixteenth(inside.y) >= sixteenth(low.y) &&
                            sixteenth(inside.x) <= sixteenth(high.x) && sixteenth(inside.y) <= sixteenth(high.y);
        ASSERT_EQ(
            shared::candidateReaches(shared::packCandidateBounds(low, high, 0u), shared::packReceiverPlace(inside, 0u)),
            within)
            << n;
        ASSERT_FALSE(shared::candidateReaches(
            shared::packCandidateBounds(vec2(0.0f), vec2(1.0f), shared::depthStep(10.0f, 0.1f)),
            shared::packReceiverPlace(inside, shared::depthStep(9.0f, 0.1f))))
            << "nearer than the candidate";
    }
    EXPECT_GT(away, 20000);
}

TEST_F(CandidateBounds, StepsOfDepthNeverDecrease) {
    for (int n = 0; n < 100000; ++n) {
        const auto least = static_cast<float>(std::exp2(number(-30.0, 10.0)));
        const auto near = static_cast<float>(oneIn(10) ? number(-1.0, 0.0) : std::exp2(number(-40.0, 30.0)));
        const float far =
            oneIn(4) ? std::nextafter(near, 1e30f) : near + static_cast<float>(std::exp2(number(-40.0, 30.0)));
        ASSERT_LE(shared::depthStep(near, least), shared::depthStep(far, least))
            << near << " " << far << " from " << least;
        ASSERT_LE(shared::depthStep(far, least), 2047u);
    }
    EXPECT_EQ(shared::depthStep(0.0f, 0.1f), 0u);
    EXPECT_EQ(shared::depthStep(1e30f, 0.1f), 2047u);
    // 128 steps per octave: a hundredth more is another step.
    EXPECT_LT(shared::depthStep(7.0f, 0.1f), shared::depthStep(7.07f, 0.1f));
}

TEST(CandidatePlaces, BoundsAndNumbersOfFourEntriesLieInTwoTexels) {
    std::set<glm::uint> words;
    for (glm::uint entry = 0; entry < 64; ++entry) {
        const glm::uint place = shared::candidatePlace(entry);
        EXPECT_EQ(place / 4 % 2, 0u);
        EXPECT_EQ(place / 8, entry / 4);
        words.insert(place);
        words.insert(place + CANDIDATES_TOGETHER);
    }
    EXPECT_EQ(words.size(), 128u);
    EXPECT_EQ(*words.rbegin(), 127u);
}

}  // namespace
}  // namespace timeshade
