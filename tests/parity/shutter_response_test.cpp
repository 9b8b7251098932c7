// The shutter's response and its integral, as C++ and as GLSL, on the same inputs.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <vector>

#include "parity/compute.h"
#include "shared/shutter_response.shared.h"

namespace timeshade {
namespace {

TEST(SharedShutterResponse, IsTheSameInBothLanguages) {
    constexpr std::size_t count = 20000;
    std::mt19937 random(1990);
    const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    std::vector<float> input;
    for (std::size_t i = 0; i < count; ++i) {
        input.push_back(static_cast<float>(i % 3));
        input.push_back(static_cast<float>(i % 8 == 0 ? 1.0 / 6.0 : 0.05 * std::exp2(number(0.0, 5.3))));
        input.push_back(static_cast<float>(i % 7 == 0 ? std::round(number(0.0, 2.0)) / 2.0 : number(0.0, 1.0)));
    }
    const std::vector<std::uint32_t> output = runOnGpu("shared/shutter_response.shared.h", R"(
    uint response = uint(in_(0));
    put(0, shutterWeight(response, in_(1), in_(2)));
    put(1, shutterExposure(response, in_(1), in_(2)));
)",
                                                       input, 3, 2);
    for (std::size_t i = 0; i < count; ++i) {
        const float* x = input.data() + 3 * i;
        const auto response = static_cast<std::uint32_t>(x[0]);
        const double weight = static_cast<double>(shared::shutterWeight(response, x[1], x[2])),
                     exposure = static_cast<double>(shared::shutterExposure(response, x[1], x[2]));
        // Differences and products of numbers up to 1, two of which may be joined into one rounding.
        double weightBound = 1.2e-7, exposureBound = 1.2e-7;
        if (response == SHUTTER_GAUSSIAN) {
            // Both weights are within 2^-15 of the truth; exposures differ by the roundings of a series over an erf.
            weightBound = std::ldexp(weight, -14);
            exposureBound = 5e-7 / std::erf(0.5 / (std::sqrt(2.0) * static_cast<double>(x[1])));
        }
        ASSERT_NEAR(static_cast<double>(std::bit_cast<float>(output[2 * i])), weight, weightBound) << "case " << i;
        ASSERT_NEAR(static_cast<double>(std::bit_cast<float>(output[2 * i + 1])), exposure, exposureBound)
            << "case " << i;
    }
}

}  // namespace
}  // namespace timeshade
