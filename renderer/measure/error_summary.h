#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace timeshade {

/// How far values in [0, 1] are from their truth. All zero where nothing was compared; all NaN where a value was not
/// finite, so that a broken one does not hide in a mean.
struct ErrorSummary {
    std::uint64_t count = 0;     ///< values that were compared
    double mean = 0.0;           ///< mean |value - truth|; the truth's own noise included
    double rms = 0.0;            ///< sqrt(max(0, meanSquare))
    double p999 = 0.0;           ///< 99.9th percentile of |value - truth| by nearest rank, noise included
    double standardError = 0.0;  ///< of rms: by how much it grows if meanSquare grows by its standard error
    double meanSquare = 0.0;     ///< mean of (value - r1)(value - r2), for two independent halves r1 and r2 of the
                                 ///< truth: its noise averages out. Unbiased, so it may be below 0
    double meanSquareDeviation = 0.0;  ///< standard error of meanSquare: how it would vary if the pixels were drawn
                                       ///< anew, those of one pixel together
};

/// Collects differences pixel by pixel.
class ErrorSum {
  public:
    explicit ErrorSum(std::size_t pixels) : products_(pixels, 0.0), counts_(pixels, 0) {}
    /// A value of this pixel, less either half of its truth. Twice the same where the truth is exact. The truth itself
    /// is taken as the mean of the halves.
    void add(std::size_t pixel, double lessFirst, double lessSecond);
    ErrorSummary summary() const;

  private:
    std::vector<double> products_;
    std::vector<std::uint32_t> counts_;
    double distances_ = 0.0;
    std::vector<float> nonZero_;  ///< distances
};

}  // namespace timeshade
