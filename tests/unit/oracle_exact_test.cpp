// The exact arithmetic that the oracle resolves doubtful samples by, against integers that cannot round.
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "oracle/expansion.h"
#include "oracle/segment_triangle.h"

namespace timeshade::oracle {
namespace {

__extension__ typedef __int128 Integer;

int signOf(Integer value) { return value > 0 ? 1 : (value < 0 ? -1 : 0); }

struct Lattice {
    std::int64_t x, y, z;
    glm::dvec3 point() const { return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}; }
    Lattice operator-(const Lattice& o) const { return {x - o.x, y - o.y, z - o.z}; }
    Lattice operator+(const Lattice& o) const { return {x + o.x, y + o.y, z + o.z}; }
    Lattice operator*(std::int64_t f) const { return {x * f, y * f, z * f}; }
};

Integer determinant(const Lattice& a, const Lattice& b, const Lattice& c) {
    return Integer{a.x} * (b.y * c.z - b.z * c.y) + Integer{a.y} * (b.z * c.x - b.x * c.z) +
           Integer{a.z} * (b.x * c.y - b.y * c.x);
}

/// The definition, for the part 1/4 < s < 3/4 of the line, in integers.
bool meetsByIntegers(const Lattice& from, const Lattice& to, const Lattice (&v)[3]) {
    const Lattice d = to - from;
    Integer sum = 0;
    bool positive = false, negative = false;
    for (int i = 0; i < 3; ++i) {
        const Integer e = determinant(d, v[(i + 1) % 3] - from, v[(i + 2) % 3] - from);
        positive = positive || e > 0;
        negative = negative || e < 0;
        sum += e;
    }
    if (positive == negative) return false;
    const Integer plane = determinant(v[0] - from, v[1] - from, v[2] - from);
    return signOf(4 * plane - sum) * signOf(sum) > 0 && signOf(4 * plane - 3 * sum) * signOf(sum) < 0;
}

TEST(Expansion, KeepsWhatDoublesLose) {
    Expansion sum = Expansion::difference(1.0, 0x1p-200);
    sum += Expansion(-1.0);
    EXPECT_EQ(sum.sign(), -1);
    EXPECT_EQ(sum.estimate(), -0x1p-200);
    sum += Expansion(0x1p-200);
    EXPECT_EQ(sum.sign(), 0);
}

TEST(Expansion, MultipliesLikeIntegers) {
    std::mt19937_64 random(1);
    std::uniform_int_distribution<std::int64_t> digit(-(std::int64_t{1} << 52), std::int64_t{1} << 52);
    for (int i = 0; i < 20000; ++i) {
        const std::int64_t a = digit(random), b = digit(random), c = digit(random), d = a + digit(random) % 3;
        Expansion value = Expansion(static_cast<double>(a)) * Expansion(static_cast<double>(b));
        value -= Expansion(static_cast<double>(d)) * static_cast<double>(c);
        ASSERT_EQ(value.sign(), signOf(Integer{a} * b - Integer{d} * c));
        value -= Expansion(static_cast<double>(a)) * static_cast<double>(b);
        value += Expansion(static_cast<double>(c)) * static_cast<double>(d);
        ASSERT_EQ(value.sign(), 0);
    }
}

/// On a small lattice a large part of all segments pass exactly through edges, corners and planes.
TEST(SegmentTriangle, AgreesWithIntegersOnSmallLattices) {
    std::mt19937 random(2);
    int met = 0, contrary = 0;
    for (const std::int64_t size : {2, 4, 40, 100000, 1 << 24}) {
        std::uniform_int_distribution<std::int64_t> coordinate(-size, size);
        const auto point = [&] { return Lattice{coordinate(random), coordinate(random), coordinate(random)}; };
        for (int i = 0; i < 100000; ++i) {
            const Lattice from = point(), to = point(), v[3] = {point(), point(), point()};
            const glm::dvec3 vertices[3] = {v[0].point(), v[1].point(), v[2].point()};
            const double length = glm::length(to.point() - from.point());
            const bool hit = meet({from.point(), to.point(), 0.25, 0.75, length}, vertices).hit;
            met += hit ? 1 : 0;
            contrary += hit != meetsByIntegers(from, to, v) ? 1 : 0;
        }
    }
    EXPECT_EQ(contrary, 0);
    EXPECT_GT(met, 5000);
}

/// Segments that pass through an edge, or have a quarter of their length just on the plane, in coordinates so large
/// that the determinants of exactly zero come out of double arithmetic as noise.
TEST(SegmentTriangle, AgreesWithIntegersWhereDoublesAreNoise) {
    std::mt19937 random(4);
    std::uniform_int_distribution<std::int64_t> coordinate(-(1 << 22), 1 << 22), step(-1, 1), share(1, 7);
    const auto point = [&] { return Lattice{coordinate(random), coordinate(random), coordinate(random)}; };
    int met = 0, contrary = 0;
    const auto compare = [&](const Lattice& from, const Lattice& to, const Lattice(&v)[3]) {
        const glm::dvec3 vertices[3] = {v[0].point(), v[1].point(), v[2].point()};
        const Meeting meeting =
            meet({from.point(), to.point(), 0.25, 0.75, glm::length(to.point() - from.point())}, vertices);
        met += meeting.hit ? 1 : 0;
        contrary += meeting.hit != meetsByIntegers(from, to, v) ? 1 : 0;
        EXPECT_TRUE(meeting.marginal);
    };
    for (int i = 0; i < 20000; ++i) {
        const Lattice from = point(), a = point(), b = point(), nudge{step(random), 0, 0};
        const std::int64_t f = share(random);
        // Half-way, the segment is at a point of the edge a b.
        const Lattice to = from + (a - from) * (2 * f) + (b - from) * (16 - 2 * f) + nudge * (i % 2);
        const Lattice overEdge[3] = {from + (a - from) * 8, from + (b - from) * 8, point() * 8};
        compare(from, to, overEdge);
        // A quarter of the way, it is at the centre of gravity.
        const Lattice quarter = point(), end = from + quarter * 4, q = from + quarter, e1 = point(), e2 = point();
        const Lattice atEnd[3] = {q - e1 - e2 + nudge * (i % 2), q + e1, q + e2};
        compare(from, end, atEnd);
    }
    EXPECT_EQ(contrary, 0);
    EXPECT_GT(met, 10000);
}

/// Planes that miss a corner by the least that doubles can say: one step in the last place decides.
TEST(SegmentTriangle, TellsOneStepInTheLastPlace) {
    const glm::dvec3 from(0.3, 0.7, 0.0), to(0.3, 0.7, 10.0);
    for (const int steps : {-1, 0, 1}) {
        double x = 0.3;
        if (steps != 0) x = std::nextafter(x, steps > 0 ? 1.0 : 0.0);
        const glm::dvec3 left[3] = {{-5.0, -5.0, 5.0}, {x, -5.0, 5.0}, {x, 5.0, 5.0}};
        const Meeting meeting = meet({from, to, 0.0, 1.0, 10.0}, left);
        EXPECT_EQ(meeting.hit, steps >= 0);
        EXPECT_TRUE(meeting.marginal);
    }
}

TEST(SegmentTriangle, LeavesNoGapBetweenNeighbours) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int i = 0; i < 20000; ++i) {
        const auto point = [&](double z) {
            return glm::dvec3(number(random), number(random), z + 0.1 * number(random));
        };
        const glm::dvec3 a = point(5.0), b = point(5.0), from = point(0.0);
        const glm::dvec3 side = glm::cross(b - a, glm::dvec3(0.0, 0.0, 1.0));
        // The end is chosen so that the segment passes through the common edge as nearly as doubles allow.
        const glm::dvec3 to = from + 2.0 * (glm::mix(a, b, 0.5 + 0.4 * number(random)) - from);
        const glm::dvec3 one[3] = {a, b, a + side}, other[3] = {b, a, b - side};
        const Segment segment{from, to, 0.0, 1.0, glm::length(to - from)};
        const Meeting first = meet(segment, one), second = meet(segment, other);
        EXPECT_TRUE(first.hit || second.hit);
        EXPECT_TRUE(first.marginal && second.marginal);
    }
}

TEST(SegmentTriangle, IsOpenAtItsEnds) {
    const glm::dvec3 triangle[3] = {{-1.0, -1.0, 5.0}, {1.0, -1.0, 5.0}, {0.0, 1.0, 5.0}};
    const glm::dvec3 below(0.0, 0.0, 0.0);
    EXPECT_TRUE(meet({below, {0.0, 0.0, 5.1}, 0.0, 1.0, 5.0}, triangle).hit);
    EXPECT_FALSE(meet({below, {0.0, 0.0, 5.0}, 0.0, 1.0, 5.0}, triangle).hit);
    EXPECT_TRUE(meet({below, {0.0, 0.0, std::nextafter(5.0, 6.0)}, 0.0, 1.0, 5.0}, triangle).hit);
    EXPECT_FALSE(meet({below, {0.0, 0.0, 10.0}, 0.5, 1.0, 10.0}, triangle).hit);
    EXPECT_TRUE(meet({below, {0.0, 0.0, 10.0}, std::nextafter(0.5, 0.0), 1.0, 10.0}, triangle).hit);
    EXPECT_FALSE(meet({below, {0.0, 0.0, -10.0}, 0.0, 1.0, 10.0}, triangle).hit);
    EXPECT_TRUE(meet({below,
                      {0.0, 0.0, 1.0},
                      0.1,
                      std::numeric_limits<double>::infinity(),
                      std::numeric_limits<double>::infinity()},
                     triangle)
                    .hit);
}

/// A plane that passes the beginning within the clearance is not met, on whichever side and at whatever angle.
TEST(SegmentTriangle, LeavesOutWhatIsWithinTheClearance) {
    for (const double gap : {1e-3, 1.01e-4, 0.99e-4, 0.0, -1e-3}) {
        const glm::dvec3 triangle[3] = {{-1.0, -1.0, gap}, {1.0, -1.0, gap}, {0.0, 1.0, gap}};
        for (const glm::dvec3& to :
             {glm::dvec3(0.0, 0.0, 10.0), glm::dvec3(100.0, 0.0, 1.0), glm::dvec3(0.0, 0.0, 1e6)})
            EXPECT_EQ(meet({{0.0, 0.0, 0.0}, to, 0.0, 1.0, 10.0, 1e-4}, triangle).hit,
                      gap > 1e-4 && gap * to.x / to.z < 0.4)
                << gap;
    }
}

TEST(SegmentTriangle, MissesWhatHasNoArea) {
    const Segment segment{{0.0, 0.0, 0.0}, {0.0, 0.0, 10.0}, 0.0, 1.0, 10.0};
    const glm::dvec3 edgeOn[3] = {{-1.0, 0.0, 4.0}, {0.0, 0.0, 6.0}, {1.0, 0.0, 4.0}};
    EXPECT_FALSE(meet(segment, edgeOn).hit);
    const glm::dvec3 point[3] = {{0.0, 0.0, 5.0}, {0.0, 0.0, 5.0}, {0.0, 0.0, 5.0}};
    EXPECT_FALSE(meet(segment, point).hit);
    const glm::dvec3 line[3] = {{-1.0, 0.0, 5.0}, {0.0, 0.0, 5.0}, {1.0, 0.0, 5.0}};
    EXPECT_FALSE(meet(segment, line).hit);
}

TEST(SegmentTriangle, SaysWhatAFloatCouldHaveDecidedOtherwise) {
    const glm::dvec3 triangle[3] = {{-1.0, -1.0, 5.0}, {1.0, -1.0, 5.0}, {1.0, 1.0, 5.0}};
    const auto meetingAt = [&](double x, double z) {
        return meet({{x, -0.5, 0.0}, {x, -0.5, z}, 0.0, 1.0, z}, triangle);
    };
    EXPECT_TRUE(meetingAt(1.0 + 1e-6, 10.0).marginal);
    EXPECT_FALSE(meetingAt(1.0 + 1e-6, 10.0).hit);
    EXPECT_TRUE(meetingAt(1.0 - 1e-6, 10.0).marginal);
    EXPECT_TRUE(meetingAt(1.0 - 1e-6, 10.0).hit);
    EXPECT_FALSE(meetingAt(1.0 + 1e-4, 10.0).marginal);
    EXPECT_FALSE(meetingAt(1.0 - 1e-4, 10.0).marginal);
    EXPECT_TRUE(meetingAt(0.5, 5.0 + 1e-6).marginal);
    EXPECT_TRUE(meetingAt(0.5, 5.0 - 1e-6).marginal);
    EXPECT_FALSE(meetingAt(0.5, 5.0 - 1e-4).marginal);
    EXPECT_FALSE(meetingAt(0.5, 5.0 + 1e-4).marginal);
}

}  // namespace
}  // namespace timeshade::oracle
