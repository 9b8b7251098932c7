#include "measure/metrics.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace timeshade {
namespace {

constexpr std::size_t channels = 3;
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

template <class Image>
void requireWhole(const Image& image) {
    const bool positive = image.width > 0 && image.height > 0;
    const std::size_t expected =
        positive ? static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * channels : 0;
    if (!positive || image.rgb.size() != expected) {
        throw Error(
            fmt::format("cannot compare images: one of {}x{} pixels holds {} values, expected 3 for each of at "
                        "least one pixel",
                        image.width, image.height, image.rgb.size()));
    }
}

template <class Image, class Other>
void requireComparable(const Image& image, const Other& reference) {
    requireWhole(image);
    requireWhole(reference);
    if (image.width != reference.width || image.height != reference.height) {
        throw Error(fmt::format("cannot compare images: {}x{} pixels against {}x{}, expected equal sizes", image.width,
                                image.height, reference.width, reference.height));
    }
}

bool isFinite(const LinearImage& image) {
    return std::all_of(image.rgb.begin(), image.rgb.end(), [](float value) { return std::isfinite(value); });
}

/// The order of the values is lost.
double nearestRank999(std::vector<double>& values) {
    // ceil(0.999 n) in whole numbers: 0.999 has no exact double.
    const std::size_t rank = values.size() - values.size() / 1000;
    const auto position = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(values.begin(), position, values.end());
    return *position;
}

}  // namespace

ErrorMetrics compareImages(const LinearImage& image, const LinearImage& reference) {
    requireComparable(image, reference);
    if (!isFinite(image) || !isFinite(reference)) {
        return {notANumber, notANumber, notANumber, notANumber, notANumber, std::nullopt};
    }
    double squares = 0.0;
    double relativeSquares = 0.0;
    double absolutes = 0.0;
    std::vector<double> distances(image.rgb.size());
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        const double r = static_cast<double>(reference.rgb[i]);
        const double d = static_cast<double>(image.rgb[i]) - r;
        squares += d * d;
        relativeSquares += d * d / (r * r + relativeMseEpsilon);
        absolutes += std::abs(d);
        distances[i] = std::abs(d);
    }
    const double count = static_cast<double>(image.rgb.size());
    ErrorMetrics metrics;
    metrics.rmse = std::sqrt(squares / count);
    metrics.relativeMse = relativeSquares / count;
    metrics.psnr = -20.0 * std::log10(metrics.rmse);
    metrics.meanAbsolute = absolutes / count;
    metrics.p999 = nearestRank999(distances);
    return metrics;
}

ErrorMetrics compareImages(const LinearImage& image, const LinearImage& reference, const DisplayImage& displayed,
                           const DisplayImage& displayedReference) {
    ErrorMetrics metrics = compareImages(image, reference);
    requireComparable(displayed, reference);
    const double share = shareOffBy(displayed, displayedReference, visibleLevels);
    // Eight bits show a NaN as some colour; the poison must reach this metric too.
    metrics.offBy30 = std::isnan(metrics.rmse) ? notANumber : share;
    return metrics;
}

double shareOffBy(const DisplayImage& image, const DisplayImage& reference, int levels) {
    requireComparable(image, reference);
    std::size_t off = 0;
    for (std::size_t first = 0; first < image.rgb.size(); first += channels) {
        int largest = 0;
        for (std::size_t i = first; i < first + channels; ++i) {
            largest = std::max(largest, std::abs(int{image.rgb[i]} - int{reference.rgb[i]}));
        }
        off += largest > levels ? 1 : 0;
    }
    return static_cast<double>(off) / static_cast<double>(image.rgb.size() / channels);
}

BiasAndNoise biasAndNoise(std::span<const LinearImage> seeds, const LinearImage& reference) {
    if (seeds.size() < 2) {
        throw Error(fmt::format("cannot tell bias from noise: {} seeds, expected at least 2", seeds.size()));
    }
    bool finite = isFinite(reference);
    for (const LinearImage& seed : seeds) {
        requireComparable(seed, reference);
        finite = finite && isFinite(seed);
    }
    if (!finite) {
        return {notANumber, notANumber, notANumber};
    }
    const double seedCount = static_cast<double>(seeds.size());
    double variances = 0.0;
    double meanSquares = 0.0;
    for (std::size_t i = 0; i < reference.rgb.size(); ++i) {
        double sum = 0.0;
        for (const LinearImage& seed : seeds) {
            sum += static_cast<double>(seed.rgb[i]);
        }
        const double mean = sum / seedCount;
        double squares = 0.0;
        for (const LinearImage& seed : seeds) {
            const double deviation = static_cast<double>(seed.rgb[i]) - mean;
            squares += deviation * deviation;
        }
        variances += squares / (seedCount - 1.0);
        const double error = mean - static_cast<double>(reference.rgb[i]);
        meanSquares += error * error;
    }
    const double count = static_cast<double>(reference.rgb.size());
    const double noiseSquare = variances / count;
    const double meanErrorSquare = meanSquares / count;
    return {std::sqrt(noiseSquare), std::sqrt(meanErrorSquare),
            std::sqrt(std::max(0.0, meanErrorSquare - noiseSquare / seedCount))};
}

std::optional<double> logLogSlope(std::span<const double> x, std::span<const double> y) {
    if (x.size() != y.size()) {
        throw Error(fmt::format("cannot fit a slope: {} values of x, {} of y, expected as many", x.size(), y.size()));
    }
    std::vector<double> logX;
    std::vector<double> logY;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (x[i] > 0.0 && y[i] > 0.0 && std::isfinite(x[i]) && std::isfinite(y[i])) {
            logX.push_back(std::log(x[i]));
            logY.push_back(std::log(y[i]));
        }
    }
    const auto [least, greatest] = std::minmax_element(logX.begin(), logX.end());
    if (logX.empty() || *least == *greatest) {
        return std::nullopt;
    }
    double meanX = 0.0;
    double meanY = 0.0;
    for (std::size_t i = 0; i < logX.size(); ++i) {
        meanX += logX[i] / static_cast<double>(logX.size());
        meanY += logY[i] / static_cast<double>(logY.size());
    }
    double covariance = 0.0;
    double variance = 0.0;
    for (std::size_t i = 0; i < logX.size(); ++i) {
        covariance += (logX[i] - meanX) * (logY[i] - meanY);
        variance += (logX[i] - meanX) * (logX[i] - meanX);
    }
    return covariance / variance;
}

}  // namespace timeshade
