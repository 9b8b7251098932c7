// The arithmetic that C++ and GLSL compile from one text, run as both on the same inputs: random ones and awkward ones,
// from a fixed seed. Integer work must agree in every bit. In floats a GPU may round a division by up to 2.5 units and
// may join a product and a sum into one rounding; each bound below states its effect.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "parity/compute.h"
#include "shared/cubic.shared.h"
#include "shared/prism_side.shared.h"
#include "shared/sample_pattern.shared.h"
#include "shared/segment_triangle.shared.h"
#include "shared/swept_bounds.shared.h"
#include "support/awkward_numbers.h"
#include "support/gl_environment.h"

namespace timeshade {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::vec2;
using glm::vec3;

float asFloat(std::uint32_t word) { return std::bit_cast<float>(word); }

class SharedNumerics : public testing::Test {
  protected:
    double number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
    bool oneIn(int n) { return std::uniform_int_distribution(1, n)(random_) == 1; }
    std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }

    /// Near 1, now and then 0, of another size, or a whole number (so that differences cancel).
    float coordinate() {
        if (oneIn(12)) return 0.0f;
        if (oneIn(8)) return static_cast<float>(std::uniform_int_distribution(-3, 3)(random_));
        const double size = oneIn(6) ? std::exp2(number(-20.0, 12.0)) : 1.0;
        return static_cast<float>(size * number(-2.0, 2.0));
    }
    std::vector<float> coordinates(std::size_t count) {
        std::vector<float> all(count);
        for (float& x : all) x = coordinate();
        return all;
    }

    std::mt19937 random_{19880307};
};

TEST_F(SharedNumerics, SamplePatternHasTheSameBits) {
    std::vector<float> input;
    std::vector<std::array<std::uint32_t, 5>> cases;  // pixel, k, seed, salt
    for (const std::uint32_t edge : {0u, 1u, 0x7fffffffu, 0x80000000u, 0xffffffffu})
        for (const std::uint32_t salt : {SALT_CAMERA, SALT_LIGHT})
            cases.push_back({edge % 16384, edge % 8191, edge % 32, edge, salt});
    while (cases.size() < 20000)
        cases.push_back({word() % 16384, word() % 16384, word() % 32, word(), oneIn(2) ? SALT_CAMERA : SALT_LIGHT});
    for (const auto& one : cases) {
        // As floats of small whole numbers: the bits of a word could be those of a NaN, which a driver may change.
        for (const std::uint32_t w : one) {
            input.push_back(static_cast<float>(w >> 16));
            input.push_back(static_cast<float>(w & 0xffffu));
        }
    }
    const std::vector<std::uint32_t> output = runOnGpu("shared/sample_pattern.shared.h", R"(
    uint w[5];
    for (int j = 0; j < 5; ++j) w[j] = (uint(in_(2 * j)) << 16) | uint(in_(2 * j + 1));
    vec3 p = samplePattern(uvec2(w[0], w[1]), w[2], w[3], w[4]);
    put(0, p.x); put(1, p.y); put(2, p.z);
    put(3, sampleTime(0.0, 0.125, w[2], p.z));
    put(4, sampleTime(0.25, 1.0 / 3.0, w[2], p.z));
    uvec3 h = hashWords(uvec3(w[3], w[0], w[4]));
    put(5, h.x); put(6, h.y); put(7, h.z);
    put(8, hashWord(w[3]));
    uint side = 1u + w[2] % 4u, phase = texelPhase(uvec2(w[0], w[1]), side);
    put(9, phase); put(10, phaseTime(phase, side));
)",
                                                       input, 10, 11);
    const bool software = sharedRenderer().device().software;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto& c = cases[i];
        const std::uint32_t* gpu = output.data() + 11 * i;
        const vec3 p = shared::samplePattern({c[0], c[1]}, c[2], c[3], c[4]);
        for (int d = 0; d < 3; ++d)
            ASSERT_EQ(gpu[d], std::bit_cast<std::uint32_t>(p[d])) << "case " << i << ", dimension " << d;
        ASSERT_EQ(gpu[3], std::bit_cast<std::uint32_t>(shared::sampleTime(0.0f, 0.125f, c[2], p.z))) << "case " << i;
        // A length that is no power of two: the product is rounded, or not where it is joined with the sum.
        ASSERT_LE(ulpsApart(asFloat(gpu[4]), shared::sampleTime(0.25f, 1.0f / 3.0f, c[2], p.z)), software ? 0u : 1u);
        const glm::uvec3 h = shared::hashWords({c[3], c[0], c[4]});
        for (int d = 0; d < 3; ++d) ASSERT_EQ(gpu[5 + d], h[d]) << "case " << i;
        ASSERT_EQ(gpu[8], shared::hashWord(c[3])) << "case " << i;
        const std::uint32_t side = 1 + c[2] % 4, phase = shared::texelPhase({c[0], c[1]}, side);
        ASSERT_EQ(gpu[9], phase);
        ASSERT_LE(ulpsApart(asFloat(gpu[10]), shared::phaseTime(phase, side)), software ? 0u : 1u);
    }
}

TEST_F(SharedNumerics, EdgeFunctionsLeaveNoGap) {
    constexpr std::size_t count = 20000;
    std::vector<float> input = coordinates(6 * count);
    for (std::size_t i = 0; i < count / 10; ++i) {  // nearly through an edge: q1 along q0
        const auto stretch = static_cast<float>(number(0.1, 3.0));
        input[6 * i + 2] = input[6 * i] * stretch;
        input[6 * i + 3] = input[6 * i + 1] * stretch;
    }
    const std::vector<std::uint32_t> output = runOnGpu("shared/moving_triangle.shared.h", R"(
    precise vec3 e = edgeFunctions(in2(0), in2(1), in2(2));
    precise vec3 f = edgeFunctions(in2(1), in2(0), in2(2));  // the neighbour across the edge of q0 and q1
    put(0, e.x); put(1, e.y); put(2, e.z); put(3, f.z);
)",
                                                       input, 6, 4);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const float* q = input.data() + 6 * i;
        const std::uint32_t* gpu = output.data() + 4 * i;
        // The edge that two triangles share, seen from both: one is in where the other is out, or both lie on it.
        ASSERT_EQ(asFloat(gpu[2]), -asFloat(gpu[3])) << "case " << i;
        const vec3 cpu = shared::edgeFunctions({q[0], q[1]}, {q[2], q[3]}, {q[4], q[5]});
        const vec3 mirrored = shared::edgeFunctions({q[2], q[3]}, {q[0], q[1]}, {q[4], q[5]});
        ASSERT_EQ(cpu.z, -mirrored.z) << "case " << i;
        for (int e = 0; e < 3; ++e) {
            const float *a = q + 2 * ((e + 1) % 3), *b = q + 2 * ((e + 2) % 3);
            const double first = static_cast<double>(a[0]) * static_cast<double>(b[1]),
                         second = static_cast<double>(a[1]) * static_cast<double>(b[0]);
            // Two products and a difference, each rounded once to 2^-24 of itself; or denormal.
            const double bound = std::ldexp(2.0 * (std::abs(first) + std::abs(second)), -24) + 1e-37;
            ASSERT_NEAR(static_cast<double>(asFloat(gpu[e])), first - second, bound) << "case " << i;
            ASSERT_NEAR(static_cast<double>(cpu[e]), first - second, bound) << "case " << i;
            differing += asFloat(gpu[e]) != cpu[e] ? 1u : 0u;
        }
    }
    // Not joined into one rounding: then the two agree but for denormals, which a GPU may flush.
    EXPECT_LE(differing, 3 * count / 1000);
}

TEST_F(SharedNumerics, DeterminantCoefficients) {
    constexpr std::size_t count = 10000;
    const std::vector<float> input = coordinates(18 * count);
    const std::vector<std::uint32_t> output = runOnGpu("shared/moving_triangle.shared.h", R"(
    vec4 c = determinantCoefficients(in3(0), in3(1), in3(2), in3(3), in3(4), in3(5));
    put(0, c.x); put(1, c.y); put(2, c.z); put(3, c.w);
)",
                                                       input, 18, 4);
    const auto exact = [](const dvec3& a, const dvec3& b, const dvec3& c) { return glm::dot(a, glm::cross(b, c)); };
    const auto size = [](const dvec3& a, const dvec3& b, const dvec3& c) {  // the sum of the sizes of all products
        const dvec3 x = glm::abs(a), y = glm::abs(b), z = glm::abs(c);
        return x.x * (y.y * z.z + y.z * z.y) + x.y * (y.z * z.x + y.x * z.z) + x.z * (y.x * z.y + y.y * z.x);
    };
    for (std::size_t i = 0; i < count; ++i) {
        const float* x = input.data() + 18 * i;
        const auto v = [&](int j) { return vec3(x[3 * j], x[3 * j + 1], x[3 * j + 2]); };
        const auto d = [&](int j) { return dvec3(v(j)); };
        const glm::vec4 cpu = shared::determinantCoefficients(v(0), v(1), v(2), v(3), v(4), v(5));
        const glm::dvec4 truth(exact(d(0), d(1), d(2)),
                               (exact(d(3), d(1), d(2)) + exact(d(0), d(4), d(2)) + exact(d(0), d(1), d(5))) / 3.0,
                               (exact(d(3), d(4), d(2)) + exact(d(3), d(1), d(5)) + exact(d(0), d(4), d(5))) / 3.0,
                               exact(d(3), d(4), d(5)));
        const glm::dvec4 sizes(
            size(d(0), d(1), d(2)), (size(d(3), d(1), d(2)) + size(d(0), d(4), d(2)) + size(d(0), d(1), d(5))) / 3.0,
            (size(d(3), d(4), d(2)) + size(d(3), d(1), d(5)) + size(d(0), d(4), d(5))) / 3.0, size(d(3), d(4), d(5)));
        for (int j = 0; j < 4; ++j) {
            // A term is rounded at most eight times on its way: difference of products (2), scalar product (3), sum
            // (2), division (up to 2.5 units on a GPU).
            const double bound = std::ldexp(10.0 * sizes[j], -24) + 1e-36;
            ASSERT_NEAR(static_cast<double>(asFloat(output[4 * i + static_cast<std::size_t>(j)])), truth[j], bound)
                << "case " << i;
            ASSERT_NEAR(static_cast<double>(cpu[j]), truth[j], bound) << "case " << i;
        }
    }
}

/// Whether the four limits of two bounds agree within `units` in the last place. A limit may also be the image's border
/// in one and not in the other, if the two numbers that decide between them all but tie.
void expectSameBounds(const shared::SweptBounds& cpu, const std::uint32_t* gpu, const shared::HomogeneousExtremes& x,
                      std::uint64_t units, std::size_t item) {
    const float limits[4] = {cpu.low.x, cpu.low.y, cpu.high.x, cpu.high.y};
    const float deciders[4][2] = {{x.frontLow.x, x.behindHigh.x},
                                  {x.frontLow.y, x.behindHigh.y},
                                  {x.frontHigh.x, x.behindLow.x},
                                  {x.frontHigh.y, x.behindLow.y}};
    for (int j = 0; j < 4; ++j) {
        const bool tie = ulpsApart(deciders[j][0], deciders[j][1]) <= 2 * units;
        ASSERT_TRUE(tie || ulpsApart(asFloat(gpu[j]), limits[j]) <= units)
            << "case " << item << ", limit " << j << ": " << asFloat(gpu[j]) << " on the GPU, " << limits[j] << " here";
    }
    ASSERT_EQ(gpu[4], cpu.crosses) << "case " << item;
}

constexpr const char* putBounds =
    "put(0, b.low.x); put(1, b.low.y); put(2, b.high.x); put(3, b.high.y); put(4, b.crosses);";

TEST_F(SharedNumerics, PrismSides) {
    constexpr std::size_t count = 20000;
    std::vector<float> input = coordinates(7 * count);  // s, u, place; slopes of time and place
    for (std::size_t i = 0; i < count; ++i)
        for (int j = 0; j < 3; ++j)
            input[7 * i + static_cast<std::size_t>(j)] =
                static_cast<float>(oneIn(10) ? std::round(number(0.0, 2.0)) / 2.0 : number(0.0, 1.0));
    const std::vector<std::uint32_t> output = runOnGpu("shared/prism_side.shared.h", R"(
    put(0, beyondFan(in_(0), in_(1)));
    put(1, stepWithinEdge(vec2(in_(3), in_(4)), vec2(in_(5), in_(6)), in_(2)));
)",
                                                       input, 7, 2);
    for (std::size_t i = 0; i < count; ++i) {
        const float* x = input.data() + 7 * i;
        // A product and a difference of numbers up to 1/4, which may be joined.
        ASSERT_NEAR(static_cast<double>(asFloat(output[2 * i])), static_cast<double>(shared::beyondFan(x[0], x[1])),
                    std::ldexp(1.0, -24))
            << "case " << i;
        const double share = static_cast<double>(shared::stepWithinEdge({x[3], x[4]}, {x[5], x[6]}, x[2]));
        const double steep = static_cast<double>(glm::length(vec2(x[5], x[6])));
        if (std::abs(steep - 1e-6) < 1e-9) continue;  // where the edge may have ends or not
        ASSERT_NEAR(static_cast<double>(asFloat(output[2 * i + 1])), share, std::ldexp(share, -19)) << "case " << i;
    }
}

TEST_F(SharedNumerics, SweptBoundsPerspective) {
    constexpr std::size_t count = 10000;
    const std::vector<float> input = coordinates(18 * count);
    const std::vector<std::uint32_t> output = runOnGpu(
        "shared/swept_bounds.shared.h",
        std::string("SweptBounds b = sweptBoundsPerspective(in3(0), in3(1), in3(2), in3(3), in3(4), in3(5), 0.01);") +
            putBounds,
        input, 18, 5);
    std::size_t whole = 0;
    for (std::size_t i = 0; i < count; ++i) {
        vec3 v[6];
        shared::HomogeneousExtremes extremes = shared::noHomogeneousPoints();
        for (std::size_t j = 0; j < 6; ++j) {
            const float* x = input.data() + 18 * i + 3 * j;
            v[j] = {x[0], x[1], x[2]};
            extremes = shared::addHomogeneousPoint(extremes, v[j]);
        }
        const shared::SweptBounds bounds = shared::sweptBoundsPerspective(v[0], v[1], v[2], v[3], v[4], v[5], 0.01f);
        whole += bounds.crosses == 0u ? 1u : 0u;
        // One division: 2.5 units on a GPU, half a unit here.
        expectSameBounds(bounds, output.data() + 5 * i, extremes, 3, i);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(whole, 50u);
    EXPECT_LT(whole, count);
}

TEST_F(SharedNumerics, SweptBoundsOrthographic) {
    constexpr std::size_t count = 10000;
    const std::vector<float> input = coordinates(18 * count);
    const std::vector<std::uint32_t> output = runOnGpu(
        "shared/swept_bounds.shared.h",
        std::string("SweptBounds b = sweptBoundsOrthographic(in3(0), in3(1), in3(2), in3(3), in3(4), in3(5));") +
            putBounds,
        input, 18, 5);
    for (std::size_t i = 0; i < count; ++i) {
        vec3 v[6];
        for (std::size_t j = 0; j < 6; ++j) {
            const float* x = input.data() + 18 * i + 3 * j;
            v[j] = {x[0], x[1], x[2]};
        }
        const shared::SweptBounds bounds = shared::sweptBoundsOrthographic(v[0], v[1], v[2], v[3], v[4], v[5]);
        // No arithmetic at all.
        expectSameBounds(bounds, output.data() + 5 * i, {vec2(0), vec2(0), vec2(9), vec2(9)}, 0, i);
        if (HasFatalFailure()) return;
    }
}

TEST_F(SharedNumerics, SweptBoundsTurning) {
    // In front of the eye and turning by up to 0.3 of a radian: the homogeneous weights stay above 1/4. (What crosses
    // the eye is divided by as little as there is; the unit test of the bounds covers it in double precision.)
    constexpr std::size_t count = 10000;
    std::vector<float> input;
    const auto rays = [&] {
        std::vector<float> columns;
        const double angle = number(-0.15, 0.15), c = std::cos(angle), s = std::sin(angle);
        // The identity turned about the image's vertical axis, and jittered: right, up, corner.
        for (const double x : {c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c})
            columns.push_back(static_cast<float>(x + number(-0.02, 0.02)));
        return columns;
    };
    for (std::size_t i = 0; i < count; ++i) {
        for (int j = 0; j < 6; ++j) {
            input.push_back(static_cast<float>(number(-1.0, 1.0)));
            input.push_back(static_cast<float>(number(-1.0, 1.0)));
            input.push_back(static_cast<float>(number(1.0, 3.0)));
        }
        for (int end = 0; end < 2; ++end)
            for (const float x : rays()) input.push_back(x);
    }
    const std::vector<std::uint32_t> output = runOnGpu("shared/swept_bounds.shared.h",
                                                       std::string(R"(
    mat4 a = mat4(mat3(in3(6), in3(7), in3(8))), c = mat4(mat3(in3(9), in3(10), in3(11)));
    SweptBounds b = sweptBoundsTurning(in3(0), in3(1), in3(2), in3(3), in3(4), in3(5), a, c);)") +
                                                           putBounds,
                                                       input, 36, 5);
    for (std::size_t i = 0; i < count; ++i) {
        const auto v = [&](std::size_t j) {
            return vec3(input[36 * i + 3 * j], input[36 * i + 3 * j + 1], input[36 * i + 3 * j + 2]);
        };
        const glm::mat4 a(glm::mat3(v(6), v(7), v(8))), c(glm::mat3(v(9), v(10), v(11)));
        const shared::SweptBounds bounds = shared::sweptBoundsTurning(v(0), v(1), v(2), v(3), v(4), v(5), a, c);
        ASSERT_EQ(bounds.crosses, 0u) << "case " << i;
        const float limits[4] = {bounds.low.x, bounds.low.y, bounds.high.x, bounds.high.y};
        for (std::size_t j = 0; j < 4; ++j) {
            // A Bezier point sums some thirty products below 4, rounded at most ten times each, over a weight above
            // 1/4; the worst case of all that at once is 2^-14, what occurs is 2^-20.
            ASSERT_NEAR(static_cast<double>(asFloat(output[5 * i + j])), static_cast<double>(limits[j]),
                        std::ldexp(1.0, -18))
                << "case " << i;
        }
        ASSERT_EQ(output[5 * i + 4], 0u) << "case " << i;
    }
}

/// No division and no contraction: the same bits, and so the same decision.
TEST_F(SharedNumerics, SegmentMeetsTriangle) {
    constexpr std::size_t count = 100000;
    AwkwardNumbers numbers(11);
    std::vector<float> input;
    for (std::size_t i = 0; i < count; ++i) {
        const SegmentAndTriangle s = awkwardSegmentAndTriangle(numbers);
        for (const vec3& v : {s.toLight, s.v[0], s.v[1], s.v[2]})
            for (int d = 0; d < 3; ++d) input.push_back(v[d]);
    }
    const std::vector<std::uint32_t> output = runOnGpu("shared/segment_triangle.shared.h", R"(
    put(0, segmentMeetsTriangle(in3(0), in3(1), in3(2), in3(3), 0.0) ? 1u : 0u);
    put(1, edgeSide(in3(0), in3(1), in3(2)));
    vec3 v = vertexFromReceiver(in3(0), in3(1), 0.3, in3(2));
    put(2, v.x); put(3, v.y); put(4, v.z);
)",
                                                       input, 12, 5);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto v = [&](std::size_t j) {
            return vec3(input[12 * i + 3 * j], input[12 * i + 3 * j + 1], input[12 * i + 3 * j + 2]);
        };
        const std::uint32_t* gpu = output.data() + 5 * i;
        ASSERT_EQ(asFloat(gpu[1]), shared::edgeSide(v(0), v(1), v(2))) << "case " << i;
        const vec3 seen = shared::vertexFromReceiver(v(0), v(1), 0.3f, v(2));
        for (int d = 0; d < 3; ++d) ASSERT_EQ(asFloat(gpu[2 + d]), seen[d]) << "case " << i;
        ASSERT_EQ(gpu[0] != 0u, shared::segmentMeetsTriangle(v(0), v(1), v(2), v(3), 0.0f)) << "case " << i;
        hits += gpu[0];
    }
    EXPECT_GT(hits, count / 10);
}

/// Divisions and roots may round otherwise on a GPU; what they lead to is the same sign wherever the cubic is not
/// nearly 0.
TEST_F(SharedNumerics, SignChangesOfCubics) {
    constexpr std::size_t count = 50000;
    const std::vector<float> input = coordinates(4 * count);
    const std::vector<std::uint32_t> output = runOnGpu("shared/cubic.shared.h", R"(
    vec4 b = vec4(in_(0), in_(1), in_(2), in_(3));
    CubicSignChanges c = signChangesOfCubic(b);
    put(0, c.count); put(1, c.at.x); put(2, c.at.y); put(3, c.at.z);
    put(4, cubicAt(b, 0.3));
    vec4 lit = positiveIntervals(b.x, b.y, b.z);
    put(5, lit.y - lit.x + lit.w - lit.z);
)",
                                                       input, 4, 6);
    std::size_t several = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec4 b(input[4 * i], input[4 * i + 1], input[4 * i + 2], input[4 * i + 3]);
        const std::uint32_t* gpu = output.data() + 6 * i;
        ASSERT_EQ(asFloat(gpu[4]), shared::cubicAt(b, 0.3f)) << "case " << i;
        const shared::CubicSignChanges here = shared::signChangesOfCubic(b);
        const shared::CubicSignChanges there{gpu[0], {asFloat(gpu[1]), asFloat(gpu[2]), asFloat(gpu[3])}};
        several += here.count > 1 ? 1u : 0u;
        const double most = std::max({std::abs(b.x), std::abs(b.y), std::abs(b.z), std::abs(b.w)});
        for (int k = 0; k <= 32; ++k) {
            const float t = static_cast<float>(k) / 32.0f;
            if (std::abs(static_cast<double>(shared::cubicAt(b, t))) <= std::ldexp(most, -17)) continue;
            ASSERT_EQ(shared::signFromChanges(b, here, t), shared::signFromChanges(b, there, t))
                << "case " << i << " at " << t;
        }
        const glm::vec4 lit = shared::positiveIntervals(b.x, b.y, b.z);
        const double d =
            static_cast<double>(b.y) * static_cast<double>(b.y) - static_cast<double>(b.x) * static_cast<double>(b.z);
        const double conditioned =
            1.0 + static_cast<double>(b.y) * static_cast<double>(b.y) / std::max(std::abs(d), 1e-12);
        ASSERT_NEAR(static_cast<double>(asFloat(gpu[5])), static_cast<double>(lit.y - lit.x + lit.w - lit.z),
                    std::ldexp(conditioned, -20))
            << "case " << i;
    }
    EXPECT_GT(several, count / 100);
}

TEST(UlpsApart, CountsFloats) {
    EXPECT_EQ(ulpsApart(1.0f, 1.0f), 0u);
    EXPECT_EQ(ulpsApart(0.0f, -0.0f), 0u);
    EXPECT_EQ(ulpsApart(1.0f, std::nextafter(1.0f, 2.0f)), 1u);
    EXPECT_EQ(ulpsApart(-std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::denorm_min()), 2u);
    EXPECT_GT(ulpsApart(1.0f, std::numeric_limits<float>::quiet_NaN()), 1u << 30);
}

}  // namespace
}  // namespace timeshade
