// The random numbers of a frame: one sample per stratum, uniform, and independent where independence is promised.
// Everything here is deterministic; limits are stated in standard deviations of what true randomness would give.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "shared/sample_pattern.shared.h"

namespace timeshade {
namespace {

using glm::uvec2;
using glm::uvec3;
using glm::vec3;
using shared::hashWord;
using shared::hashWords;
using shared::samplePattern;
using shared::sampleTime;
using shared::unitInterval;

constexpr unsigned side = 256;
constexpr unsigned pixelCount = side * side;
// Of a few hundred tests none should come this far out by chance (1 in 10^8 each, one-sided).
constexpr double farOut = 5.6;

/// One number per pixel of a square image.
std::vector<double> overImage(const std::function<float(uvec2)>& value) {
    std::vector<double> values;
    values.reserve(pixelCount);
    for (unsigned y = 0; y < side; ++y)
        for (unsigned x = 0; x < side; ++x) values.push_back(static_cast<double>(value({x, y})));
    return values;
}

/// How far the counts are from equal shares, in standard deviations of the chi-square statistic.
double unevenness(const std::vector<unsigned>& counts) {
    double total = 0.0, statistic = 0.0;
    for (const unsigned count : counts) total += count;
    const double expected = total / static_cast<double>(counts.size());
    for (const unsigned count : counts) statistic += (count - expected) * (count - expected) / expected;
    const double freedom = static_cast<double>(counts.size()) - 1.0;
    return (statistic - freedom) / std::sqrt(2.0 * freedom);
}

/// The same for pairs of numbers in [0, 1): a 16 x 16 histogram. Sensitive to any dependence, not only a linear one.
double unevennessOfPairs(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<unsigned> counts(256);
    for (std::size_t i = 0; i < a.size(); ++i)
        ++counts[static_cast<std::size_t>(a[i] * 16.0) * 16 + static_cast<std::size_t>(b[i] * 16.0)];
    return unevenness(counts);
}

/// Linear correlation, in standard deviations of independent numbers.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - 0.5) * (b[i] - 0.5);
    const auto n = static_cast<double>(a.size());
    return 12.0 * sum / n * std::sqrt(n);
}

void expectIndependent(const std::vector<double>& a, const std::vector<double>& b, const std::string& what) {
    EXPECT_LT(std::abs(unevennessOfPairs(a, b)), farOut) << what;
    EXPECT_LT(std::abs(correlation(a, b)), farOut) << what;
}

std::vector<double> dimension(int d, unsigned k, unsigned seed, unsigned salt = SALT_CAMERA, uvec2 shift = {0, 0}) {
    return overImage([=](uvec2 pixel) { return samplePattern(pixel + shift, k, seed, salt)[d]; });
}

TEST(UnitInterval, IsExactAndNeverOne) {
    EXPECT_EQ(unitInterval(0u), 0.0f);
    EXPECT_EQ(unitInterval(0xffu), 0.0f);
    EXPECT_EQ(unitInterval(0x100u), std::ldexp(1.0f, -24));
    EXPECT_EQ(unitInterval(0x80000000u), 0.5f);
    EXPECT_EQ(unitInterval(0xffffffffu), 1.0f - std::ldexp(1.0f, -24));
}

TEST(SamplePattern, StaysInsideItsPixelAndStratum) {
    for (const unsigned strata : {1u, 2u, 3u, 8u, 13u, 32u}) {
        const float scale = 1.0f / static_cast<float>(strata);
        for (unsigned i = 0; i < 20000; ++i) {
            const uvec2 pixel(i % 141, i / 141);
            for (unsigned k = 0; k < strata; ++k) {
                const vec3 p = samplePattern(pixel, k, i, SALT_CAMERA);
                ASSERT_GE(glm::min(glm::min(p.x, p.y), p.z), 0.0f);
                ASSERT_LT(glm::max(glm::max(p.x, p.y), p.z), 1.0f);
                // The end of a stratum may be reached, by the rounding of k + xi.
                const float u = sampleTime(0.0f, scale, k, p.z);
                ASSERT_GE(u, static_cast<float>(k) * scale);
                ASSERT_LE(u, static_cast<float>(k + 1) * scale);
            }
        }
    }
}

TEST(SamplePattern, TimesOfAnInstantAreThatInstant) {
    for (unsigned k = 0; k < 32; ++k)
        EXPECT_EQ(sampleTime(0.375f, 0.0f, k, samplePattern({k, 7}, k, 3, SALT_CAMERA).z), 0.375f);
}

/// A camera sample at the pixel's centre keeps its time; elsewhere it is the pattern's.
TEST(SamplePattern, PixelCentresMoveNothingInTime) {
    for (unsigned k = 0; k < 32; ++k) {
        const vec3 pattern = samplePattern({5, k}, k, 3, SALT_CAMERA);
        EXPECT_EQ(shared::cameraSample({5, k}, k, 3, 0), pattern);
        EXPECT_EQ(shared::cameraSample({5, k}, k, 3, 1), vec3(0.5f, 0.5f, pattern.z));
    }
}

TEST(SamplePattern, IsUniformInEveryDimension) {
    for (const unsigned seed : {0u, 1u, 2u, 0xffffffffu}) {
        for (const unsigned k : {0u, 1u, 7u, 31u}) {
            for (int d = 0; d < 3; ++d) {
                std::vector<unsigned> counts(1024);
                for (const double value : dimension(d, k, seed)) ++counts[static_cast<std::size_t>(value * 1024.0)];
                EXPECT_LT(std::abs(unevenness(counts)), farOut)
                    << "dimension " << d << ", k " << k << ", seed " << seed;
            }
        }
    }
}

TEST(SamplePattern, DimensionsAreIndependent) {
    for (const unsigned k : {0u, 5u})
        for (const auto& [a, b] : {std::pair{0, 1}, {0, 2}, {1, 2}})
            expectIndependent(dimension(a, k, 1), dimension(b, k, 1),
                              "dimensions " + std::to_string(a) + " and " + std::to_string(b));
}

TEST(SamplePattern, NeighbouringPixelsAreIndependent) {
    for (const uvec2 shift :
         {uvec2(1, 0), uvec2(0, 1), uvec2(1, 1), uvec2(2, 0), uvec2(16, 0), uvec2(0, 64), uvec2(256, 0)})
        for (int d = 0; d < 3; ++d)
            expectIndependent(
                dimension(d, 0, 1), dimension(d, 0, 1, SALT_CAMERA, shift),
                "dimension " + std::to_string(d) + ", " + std::to_string(shift.x) + " by " + std::to_string(shift.y));
}

TEST(SamplePattern, SeedsAndViewsAreIndependent) {
    for (int d = 0; d < 3; ++d) {
        for (const unsigned seed : {0u, 2u, 3u, 257u, 0x10001u, 0x1000001u, 0x80000001u})
            expectIndependent(dimension(d, 0, 1), dimension(d, 0, seed), "seeds 1 and " + std::to_string(seed));
        expectIndependent(dimension(d, 0, 1), dimension(d, 0, 1, SALT_LIGHT), "camera and light");
    }
}

TEST(SamplePattern, TimesOfDifferentStrataAreIndependent) {
    const std::vector<double> first = dimension(2, 0, 1);
    for (unsigned k = 1; k < 32; ++k) expectIndependent(first, dimension(2, k, 1), "strata 0 and " + std::to_string(k));
}

TEST(SamplePattern, PixelsAreSampledMoreEvenlyThanAtRandom) {
    // The share of N samples below a slanted edge through the pixel: independent samples are off by sqrt(p (1 - p) /
    // N).
    for (const unsigned n : {8u, 16u, 32u}) {
        double squares = 0.0, independent = 0.0;
        for (unsigned i = 0; i < 4096; ++i) {
            const double slope = -1.0 + 2.0 * (i % 64) / 63.0;
            unsigned below = 0;
            for (unsigned k = 0; k < n; ++k) {
                const vec3 p = samplePattern({i % 64, i / 64}, k, 1, SALT_CAMERA);
                below += static_cast<double>(p.y) - 0.5 < slope * (static_cast<double>(p.x) - 0.5) ? 1u : 0u;
            }
            const double error = static_cast<double>(below) / n - 0.5;
            squares += error * error;
            independent += 0.25 / n;
        }
        EXPECT_LT(squares, 0.35 * independent) << n << " samples";
    }
}

TEST(FixedTimes, EveryBlockHasEachPartOfTheStratumOnce) {
    for (const unsigned block : {1u, 2u, 3u, 4u}) {
        for (const uvec2 corner : {uvec2(0, 0), uvec2(1, 0), uvec2(5, 7)}) {
            std::set<unsigned> parts;
            for (unsigned y = 0; y < block; ++y)
                for (unsigned x = 0; x < block; ++x) {
                    const unsigned phase = shared::texelPhase(corner + uvec2(x, y), block);
                    EXPECT_EQ(phase, shared::texelPhase(corner + uvec2(x + block, y + 3 * block), block));
                    // The centre of one of block^2 equal parts.
                    const double part = static_cast<double>(shared::phaseTime(phase, block)) * block * block;
                    EXPECT_NEAR(part - std::floor(part), 0.5, 1e-6);
                    parts.insert(static_cast<unsigned>(part));
                }
            EXPECT_EQ(parts.size(), block * block);
            EXPECT_EQ(*parts.rbegin(), block * block - 1);
        }
    }
}

TEST(HashWord, IsAPermutationThatMixes) {
    std::set<unsigned> seen;
    for (unsigned i = 0; i < 100000; ++i) seen.insert(hashWord(i * 0x9e3779b9u));
    EXPECT_EQ(seen.size(), 100000u) << "two words have one hash";
    // Avalanche: each input bit flips each output bit half of the time.
    constexpr unsigned trials = 4096;
    for (unsigned bit = 0; bit < 32; ++bit) {
        std::array<unsigned, 32> turned{};
        for (unsigned i = 0; i < trials; ++i) {
            const unsigned word = hashWords({i, 1, 2}).x;
            const unsigned difference = hashWord(word) ^ hashWord(word ^ (1u << bit));
            for (unsigned out = 0; out < 32; ++out) turned[out] += difference >> out & 1u;
        }
        // 8 standard deviations of fair coins, and the mixer's own published bias below 1 %.
        for (unsigned out = 0; out < 32; ++out)
            EXPECT_NEAR(turned[out] / static_cast<double>(trials), 0.5, 8.0 * 0.5 / 64.0) << bit << " to " << out;
    }
}

TEST(HashWords, HasTheBitsOfThePaper) {
    // PCG3D written anew from Jarzynski and Olano's text, with 64-bit arithmetic and explicit remainders.
    for (unsigned i = 0; i < 1000; ++i) {
        const uvec3 input(i * 2654435761u, i ^ 0x55555555u, ~i);
        std::array<std::uint64_t, 3> v{input.x, input.y, input.z};
        constexpr std::uint64_t words = std::uint64_t{1} << 32;
        for (std::uint64_t& x : v) x = (x * 1664525 + 1013904223) % words;
        for (int round = 0; round < 2; ++round) {
            for (std::size_t d = 0; d < 3; ++d) v[d] = (v[d] + v[(d + 1) % 3] * v[(d + 2) % 3] % words) % words;
            if (round == 0)
                for (std::uint64_t& x : v) x ^= x >> 16;
        }
        const uvec3 hashed = hashWords(input);
        ASSERT_EQ(hashed.x, v[0]);
        ASSERT_EQ(hashed.y, v[1]);
        ASSERT_EQ(hashed.z, v[2]);
    }
}

}  // namespace
}  // namespace timeshade
