#pragma once

#include "image/image_file.h"

#include <optional>
#include <span>

namespace timeshade {

/// Relative MSE divides by r² + this: where the reference is darker than 0.1 of display white, the error counts as
/// it is, and not as a share of next to nothing.
inline constexpr double relativeMseEpsilon = 0.01;

/// Pixels further apart than this, of 255 after display encoding, are seen by anyone.
inline constexpr int visibleLevels = 30;

/// How far an image is from its reference. With x a value of the image, r of the reference at the same pixel and
/// channel, d = x - r in linear light, and n = 3 * width * height values, all weighted alike:
struct ErrorMetrics {
    double rmse = 0.0;              ///< sqrt(mean d²)
    double relativeMse = 0.0;       ///< mean of d² / (r² + relativeMseEpsilon)
    double psnr = 0.0;              ///< decibels for a peak of 1: -20 log10(rmse); +infinity where the images are equal
    double meanAbsolute = 0.0;      ///< mean |d|
    double p999 = 0.0;              ///< 99.9th percentile by nearest rank: the smallest |d| of the image that at least
                                    ///< 0.999 n of all |d| do not exceed; below 1000 values this is the largest |d|
    std::optional<double> offBy30;  ///< shareOffBy(.., visibleLevels); none where no display images were given
};

/// Sums are taken in double precision, in the order of the pixels. A NaN or an infinity anywhere in either image makes
/// every metric NaN, on purpose: a broken pixel must not hide in a mean. Throws Error where the sizes differ or an
/// image is empty.
ErrorMetrics compareImages(const LinearImage& image, const LinearImage& reference);

/// The same, with offBy30 from how both are displayed.
ErrorMetrics compareImages(const LinearImage& image, const LinearImage& reference, const DisplayImage& displayed,
                           const DisplayImage& displayedReference);

/// The share (0 to 1) of pixels with at least one channel more than `levels` of 255 away. Exactly `levels` is not
/// counted. Throws Error as compareImages does.
double shareOffBy(const DisplayImage& image, const DisplayImage& reference, int levels);

/// What of a technique's error stays however often it is repeated, and what averages out. With m seeds:
struct BiasAndNoise {
    double noise = 0.0;      ///< sqrt(mean over values of the variance between seeds, with divisor m - 1): the RMS
                             ///< distance of one image from the mean of infinitely many
    double meanError = 0.0;  ///< RMS over values of (mean over seeds - reference), as measured: bias and leftover noise
    double bias = 0.0;  ///< sqrt(max(0, meanError² - noise² / m)). Noise alone makes meanError² = noise² / m on
                        ///< average, so this square is unbiased until it is cut at 0. The reference's own
                        ///< error counts as bias
};

/// `seeds` are images of one frame that differ in the seed only. NaN and infinity poison all three, as above. Throws
/// Error for fewer than two seeds, for different sizes and for empty images.
BiasAndNoise biasAndNoise(std::span<const LinearImage> seeds, const LinearImage& reference);

/// The slope of the least-squares line through (log x, log y): -0.5 where an error falls with the square root of x.
/// Points that have no logarithm (0, negative, not finite) are left out. None where fewer than two different x are
/// left. Throws Error where x and y differ in number.
std::optional<double> logLogSlope(std::span<const double> x, std::span<const double> y);

}  // namespace timeshade
