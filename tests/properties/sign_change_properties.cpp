// Where polynomials of degree 5 and 9 change their sign, by shared/quintic.shared.h and nonic.shared.h, against values
// in double precision: five million random and awkward polynomials. With sanitizers, which look for undefined behaviour
// and take ten times as long, a tenth of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>
#include <vector>

#include "shared/nonic.shared.h"
#include "support/awkward_numbers.h"

namespace timeshade {
namespace {

template <std::size_t N>
using Coefficients = std::array<float, N>;

/// Nearly double roots, roots at both ends and in tight groups, coefficients of very different sizes, or all but 0.
template <std::size_t N>
Coefficients<N> awkwardCoefficients(AwkwardNumbers& numbers) {
    Coefficients<N> b{};
    for (float& value : b) value = numbers.coordinate();
    switch (numbers.below(6)) {
    case 0: {  // a product of linear factors, some of them nearly equal
        std::array<double, N> p{};
        p[0] = 1.0;
        float root = numbers.unit();
        for (std::size_t degree = 1; degree < N; ++degree) {
            root = numbers.oneIn(2) ? numbers.near(root) : numbers.between(-0.2f, 1.2f);
            const double first = -static_cast<double>(root), last = 1.0 - static_cast<double>(root);
            for (std::size_t i = degree + 1; i-- > 0;) {
                const double share = static_cast<double>(i) / static_cast<double>(degree);
                p[i] = (i < degree ? (1.0 - share) * p[i] * first : 0.0) + (i > 0 ? share * p[i - 1] * last : 0.0);
            }
        }
        for (std::size_t i = 0; i < N; ++i) b[i] = static_cast<float>(p[i]);
        break;
    }
    case 1: b.front() = numbers.near(0.0f); break;
    case 2: b.back() = numbers.near(0.0f); break;
    case 3:
        for (float& value : b) value = numbers.near(1.0f) - 1.0f;
        break;
    default: break;
    }
    return b;
}

template <std::size_t N>
double valueAt(const Coefficients<N>& b, double u) {
    std::array<double, N> p{};
    for (std::size_t i = 0; i < N; ++i) p[i] = static_cast<double>(b[i]);
    for (std::size_t n = N - 1; n > 0; --n)
        for (std::size_t i = 0; i < n; ++i) p[i] += (p[i + 1] - p[i]) * u;
    return p[0];
}

std::vector<float> changesOf(const Coefficients<6>& b, float doubt) {
    const shared::QuinticChanges c = shared::quinticChanges({{b[0], b[1], b[2]}, {b[3], b[4], b[5]}}, doubt);
    return {c.first.x, c.first.y, c.first.z, c.second.x, c.second.y};
}

std::vector<float> changesOf(const Coefficients<10>& b, float doubt) {
    const shared::NonicChanges c =
        shared::nonicChanges({{b[0], b[1], b[2], b[3]}, {b[4], b[5], b[6], b[7]}, {b[8], b[9]}}, doubt);
    return {c.first.x, c.first.y, c.first.z, c.first.w, c.second.x, c.second.y, c.second.z, c.second.w, c.last};
}

/// Between two times at which the value is beyond doubt, the changes are even in number if it has one sign at both, and
/// odd if it has not. Flipping all signs changes nothing.
template <std::size_t N>
bool changesAreThoseOfTheValues(AwkwardNumbers& numbers) {
    const Coefficients<N> b = awkwardCoefficients<N>(numbers);
    float size = 0.0f;
    for (const float value : b) size = std::max(size, std::abs(value));
    const float doubt = size * 0x1p-20f;
    const std::vector<float> changes = changesOf(b, doubt);
    Coefficients<N> flipped = b;
    for (float& value : flipped) value = -value;
    if (numbers.oneIn(8) && changesOf(flipped, doubt) != changes) return false;
    double lastValue = 0.0, lastTime = 0.0;
    for (int i = 0; i <= 8; ++i) {
        const double u = (i + (i == 0 || i == 8 ? 0.0 : static_cast<double>(numbers.unit()) - 0.5)) / 8.0;
        const double value = valueAt(b, u);
        if (std::abs(value) <= 4.0 * static_cast<double>(doubt)) continue;
        const auto between = std::count_if(changes.begin(), changes.end(), [&](float at) {
            return static_cast<double>(at) > lastTime && static_cast<double>(at) < u;
        });
        if (lastValue != 0.0 && ((lastValue > 0.0) != (value > 0.0)) != (between % 2 == 1)) return false;
        lastValue = value;
        lastTime = u;
    }
    return true;
}

/// How many of so many inputs, half of them on each of two threads, are wrong.
template <typename Check>
long failures(long count, std::uint32_t seed, const Check& check) {
    long failed[2] = {0, 0};
    std::thread threads[2];
    for (int t = 0; t < 2; ++t)
        threads[t] = std::thread([&, t] {
            AwkwardNumbers numbers(2 * seed + static_cast<std::uint32_t>(t));
            for (long i = 0; i < count / 2; ++i) failed[t] += check(numbers) ? 0 : 1;
        });
    for (std::thread& thread : threads) thread.join();
    return failed[0] + failed[1];
}

#ifdef __SANITIZE_ADDRESS__
constexpr long kShare = 10;
#else
constexpr long kShare = 1;
#endif

TEST(SignChanges, OfDegreeFiveAreThoseOfItsValues) {
    EXPECT_EQ(failures(4000000 / kShare, 1, changesAreThoseOfTheValues<6>), 0);
}

TEST(SignChanges, OfDegreeNineAreThoseOfItsValues) {
    EXPECT_EQ(failures(1000000 / kShare, 2, changesAreThoseOfTheValues<10>), 0);
}

}  // namespace
}  // namespace timeshade
