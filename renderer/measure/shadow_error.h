#pragma once

#include <cstdint>
#include <vector>

#include "measure/error_summary.h"
#include "measure/reference_visibility.h"

namespace timeshade {

/// Shadow error of one frame: the mean of `lit` over each pixel's samples that face the light inside its cone, each
/// with the weight that the shutter's response gives it in the picture, against the pixel's converged visibility.
/// Sampling noise is part of it. Pixels are chosen by the reference, all weigh alike;
/// left out are those in which no sample was tested (no value), and samples of pixels that the reference does
/// not have (no truth). Which those are depends on the camera samples alone, not on the technique.
struct ShadowError {
    ErrorSummary error;                        ///< its count is that of the pixels that were compared
    std::uint64_t pixelsWithoutSamples = 0;    ///< the reference has a visibility, but no sample was tested
    std::uint64_t pixelsWithoutReference = 0;  ///< the reverse
    int rays = 0;                              ///< of the reference, a pixel
};

/// Collects the samples of all renders of a frame.
class PixelMeans {
  public:
    explicit PixelMeans(std::size_t pixels) : sums_(pixels, 0.0), weights_(pixels, 0.0) {}
    /// `weight`: of the shutter's response at the sample's time; any constant for samples of equal weight.
    void add(std::size_t pixel, double lit, double weight = 1.0) {
        sums_[pixel] += weight * lit;
        weights_[pixel] += weight;
    }
    /// Pixels in the order of the reference, as many as it has. Throws Error where the numbers differ.
    ShadowError against(const ReferenceVisibility& reference) const;

  private:
    std::vector<double> sums_, weights_;
};

}  // namespace timeshade
