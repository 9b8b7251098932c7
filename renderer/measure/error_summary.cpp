#include "measure/error_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace timeshade {

namespace {

/// The smallest of the distances (and so many zeros) that at least 0.999 of all do not exceed.
double nearestRank999(std::vector<float> nonZero, std::uint64_t zeros) {
    const std::uint64_t all = zeros + nonZero.size();
    const std::uint64_t rank = all - all / 1000;  // ceil(0.999 all): 0.999 has no exact double
    if (rank <= zeros) return 0.0;
    const auto place = nonZero.begin() + static_cast<std::ptrdiff_t>(rank - zeros - 1);
    std::nth_element(nonZero.begin(), place, nonZero.end());
    return static_cast<double>(*place);
}

}  // namespace

void ErrorSum::add(std::size_t pixel, double lessFirst, double lessSecond) {
    const double distance = std::abs(0.5 * (lessFirst + lessSecond));
    products_[pixel] += lessFirst * lessSecond;
    ++counts_[pixel];
    distances_ += distance;
    if (distance != 0.0) nonZero_.push_back(static_cast<float>(distance));
}

ErrorSummary ErrorSum::summary() const {
    ErrorSummary s;
    std::uint64_t pixels = 0;
    double sum = 0.0;
    for (std::size_t i = 0; i < products_.size(); ++i) {
        s.count += counts_[i];
        pixels += counts_[i] > 0 ? 1 : 0;
        sum += products_[i];
    }
    if (s.count == 0) return s;
    if (!std::isfinite(distances_)) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        return {s.count, nan, nan, nan, nan, nan, nan};
    }
    const double count = static_cast<double>(s.count);
    s.mean = distances_ / count;
    s.meanSquare = sum / count;
    s.rms = std::sqrt(std::max(0.0, s.meanSquare));
    s.p999 = nearestRank999(nonZero_, s.count - nonZero_.size());
    double squares = 0.0;
    for (std::size_t i = 0; i < products_.size(); ++i) {
        const double deviation = products_[i] - s.meanSquare * static_cast<double>(counts_[i]);
        squares += deviation * deviation;
    }
    // Of a ratio of two sums over pixels (Cochran, "Sampling Techniques", section 6.3).
    if (pixels > 1)
        s.meanSquareDeviation =
            std::sqrt(squares * static_cast<double>(pixels) / static_cast<double>(pixels - 1)) / count;
    s.standardError = std::sqrt(std::max(0.0, s.meanSquare) + s.meanSquareDeviation) - s.rms;
    return s;
}

}  // namespace timeshade
