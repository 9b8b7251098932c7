#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "measure/equal_search.h"
#include "measure/sweep.h"

namespace timeshade {

struct EqualOptions {
    EqualLevel level = EqualLevel::Time;
    std::vector<std::string> techniques;  ///< TechniqueVariants, two or more; the first sets the time or the error
    std::vector<std::pair<std::string, std::string>> settings;  ///< "tsm.bias", "0.5"
    std::vector<MapSize> mapSizes{512};                         ///< that the others may take
    int rounds = 3;              ///< in which what is reported is timed in turn; one for trials of the search
    int steadyFrames = 3;        ///< timed in each round
    int referenceSamples = 256;  ///< per pixel, of the reference picture
    int referenceRays = 1024;    ///< per pixel, of the converged visibility; above 0
    std::function<void(const std::string&)> progress;  ///< told what is being done, if set
};

/// One technique, as it comes level with the first; or the first itself.
struct EqualRow {
    std::string technique;  ///< a TechniqueVariant
    std::string title;      ///< for people
    int sampleCount = 8;    ///< samples per pixel, or renders
    bool bruteForce = false;
    MapSize mapSize = 512;
    Timing steady;                     ///< milliseconds of steady frames
    double firstMilliseconds = 0.0;    ///< median of the first technique's, in turn with these
    ErrorSummary shadowError;          ///< against the converged visibility
    std::optional<double> wrongPpm{};  ///< wrong shadow samples in a million, where each value is a single test
    std::size_t bytes = 0, techniqueBytes = 0;
    std::optional<EqualFind> find{};  ///< none for the first; ratios of times or errors, as the level says
    DisplayImage picture;             ///< as `shot` draws it
};

struct EqualScene {
    std::string name;
    std::vector<EqualRow> rows;  ///< in the order of the techniques
    DisplayImage reference;
    int referenceRays = 0;
};

/// Measures one scene. The request is that of the first technique: its samples, its map. Times are medians of steady
/// frames of a FrameClock, those of a trial in turn with those of the first technique, so that drift hits both alike;
/// errors are those of the requested frame. The others take from 1 to maximumSamplesPerPixel samples, brute force from
/// 1 to mostRenders renders. Of several maps, level in time: that with the least shadow error of those which come
/// within equalTolerance, the nearest in time where none does. Level in error: the one that takes the least time.
EqualScene measureEqual(FrameRenderer& renderer, const EqualOptions& options, const SweepScene& scene,
                        ReferenceCache& cache);

inline constexpr int mostRenders = 512;

}  // namespace timeshade
