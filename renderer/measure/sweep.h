#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "frame/frame_renderer.h"
#include "measure/frame_clock.h"
#include "measure/metrics.h"
#include "measure/reference_cache.h"
#include "measure/verification.h"

namespace timeshade {

/// One setting of the experiment.
struct SweepPoint {
    std::string scene;
    std::string technique;  ///< a TechniqueVariant, or "embree" for the Embree baseline
    int sampleCount = 8;    ///< samples per pixel; brute force draws bruteForceRenders(sampleCount) renders instead
    MapSize mapSize = 512;
    std::string varied{};  ///< the scene's setting that the sweep varies: "cubes.count"; empty for none
    double variedValue = 0.0;

    /// Unique in a sweep; with the state, what rows are known by in the journal.
    std::string key() const;
};

/// Brute force is given renders in place of samples: 8 for each sample per pixel that the others take.
inline constexpr int bruteForceRenders(int sampleCount) { return 8 * sampleCount; }

/// Milliseconds of one step, over the rounds and the frames of each.
struct Timing {
    double median = 0.0, low = 0.0, high = 0.0;
};

/// Of the values, which are at least one: the median (of an even number the upper), the least, the greatest.
Timing timingOf(std::vector<double> values);

/// One point in one state. The state decides the times alone: errors and statistics are those of the requested frame
/// as `shot` draws it, equal in all rows of a point.
struct SweepRow {
    SweepPoint point;
    FrameState state = FrameState::Steady;
    int renders = 1;                             ///< of brute force, whose times are those of all of them together
    std::map<std::string, Timing> steps;         ///< sample, build, lookup, shade, total; and parts: "build/collect"
    std::vector<TechniqueStatistic> statistics;  ///< what the technique counted in the first seed's picture
    ErrorMetrics error;                          ///< of the first seed's picture, in linear light
    double referenceNoise = 0.0;                 ///< part of error.rmse that is the reference image's own
    BiasAndNoise biasAndNoise;                   ///< over all rounds, each with a seed of its own
    Verification verification;                   ///< shadow and footprint error, counts; of the first seed's samples
    std::size_t bytes = 0;                       ///< GPU memory, all of the frame
    std::size_t techniqueBytes = 0;
};

struct SweepScene {
    std::string name;
    const Scene* scene = nullptr;
    std::string varied{};  ///< as in SweepPoint; scenes of one name then differ in the value
    double variedValue = 0.0;
    FrameRequest request;  ///< size, frame, shutter, camera; samples, map and seed are the sweep's
};

struct SweepOptions {
    std::vector<SweepScene> scenes;
    std::vector<std::string> techniques;  ///< TechniqueVariants; "embree" among them adds the baseline
    std::vector<std::pair<std::string, std::string>> settings;  ///< "tsm.bias", "0.5"
    std::vector<int> sampleCounts{1, 2, 4, 8, 16};
    std::vector<MapSize> mapSizes{512};
    int rounds = 3;    ///< at least 2; each times every point once, in turn, with another seed
    int sequence = 0;  ///< frames timed as steady ones in a round; then there are rows for caches that fill as well. 0:
                       ///< one such frame, and no rows for that
    int referenceSamples = 256;  ///< per pixel, of the reference image
    int referenceRays = 1024;    ///< per pixel, of the converged visibility that shadow errors need; 0: no such errors
    std::filesystem::path journal;  ///< finished rows are kept here, one JSON line each
    std::string commit;             ///< of the program; rows of another are measured again
    /// Told where rows of an earlier sweep are not used, and why not.
    std::function<void(const std::string&)> note;
    /// What is being done, how many of how many steps are done, and seconds left (negative: not known yet).
    std::function<void(const std::string&, int, int, double)> progress;
};

/// Runs the experiment: per scene, every point is timed once per round, so that drift hits all alike, by a FrameClock.
/// Rows that the journal already holds, made with just the same, are not measured again. Rows come in the order scene,
/// technique, map, sample count, state. Where nothing may be cached there are cold rows alone, as for Embree, which
/// keeps nothing.
std::vector<SweepRow> runSweep(FrameRenderer& renderer, const SweepOptions& options, ReferenceCache& cache);

}  // namespace timeshade
