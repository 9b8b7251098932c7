#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace timeshade {

/// Two times, or two errors, are equal where one is within this share of the other.
inline constexpr double equalTolerance = 0.05;

/// What two techniques are to have in common.
enum class EqualLevel { Time, Error };

/// A number of samples (per pixel, or renders) that was tried, with its time or error as a share of the first
/// technique's.
struct EqualTrial {
    int sampleCount = 0;
    double ratio = 0.0;
    bool operator==(const EqualTrial&) const = default;
};

/// How one technique comes level with the first.
struct EqualFind {
    EqualTrial chosen;
    bool found = false;  ///< time: within the tolerance. Error: at most the first's and the tolerance
    /// The neighbours between which the first's value lies: the most samples that take less time or have more error,
    /// the fewest that take as much time or more, or have no more error. One is missing where the value lies beyond the
    /// fewest or the most samples.
    std::optional<EqualTrial> fewer, more;

    bool isEqual() const;  ///< within the tolerance, either way
};

/// Whether a ratio is within the tolerance of 1.
bool isEqualRatio(double ratio);

/// Measures the ratios of these sample counts, side by side. `closely`: they are to be chosen from.
using MeasureRatios = std::function<std::vector<double>(const std::vector<int>& sampleCounts, bool closely)>;

/// The sample count whose time is nearest to the first's, by ratio. A SampleCountSearch finds two neighbours, which are
/// then measured anew side by side, as the search has chosen them with the noise of single measurements; where the
/// first's time turns out to lie on one side of both, the next neighbour is taken instead, a few times. Of sample
/// counts that are equally near the fewest. `sampleCounts` are in ascending order, not empty.
EqualFind findEqualTime(const std::vector<int>& sampleCounts, const MeasureRatios& measure);

/// The fewest samples whose error is at most the first's, within the tolerance, by a SampleCountSearch: the fewest of
/// all where errors fall with samples. Where none are enough: those with the least error of all that were tried.
EqualFind findEqualError(const std::vector<int>& sampleCounts, const MeasureRatios& measure);

}  // namespace timeshade
