#pragma once

#include <cstdint>
#include <optional>

#include "plan/map_size.h"
#include "scene/camera.h"
#include "scene/looping.h"
#include "scene/shutter.h"

namespace timeshade {

/// Where the camera samples of a frame come from.
enum class CameraSamples {
    Strata,    ///< each has one time, in its own stratum of the shutter
    Intervals  ///< none has a time: each is a position, and what it sees when is solved for (docs/numerics.md)
};

/// Everything about a frame that does not depend on the technique. Equal requests for one scene give equal frames.
struct FrameRequest {
    int width = 640;  ///< pixels, 1 .. 16384
    int height = 480;
    CameraSamples samples = CameraSamples::Strata;
    int samplesPerPixel = 8;  ///< 1 .. 32, one per stratum of the shutter; of interval samples the positions
    /// 1 .. 32, of interval samples: strata of the shutter, in each of which a technique that tests instants tests one.
    int timeStrata = 8;
    MapSize mapSize;
    std::uint32_t seed = 1;
    double frame = 0.0;  ///< number of the frame; whole numbers unless scrubbing
    Shutter shutter;
    Looping looping = Looping::Auto;
    std::size_t cameraIndex = 0;
    bool forceDynamic = false;  ///< treat every triangle as dynamic, cull no unseen shadow, cache nothing
    bool useCaches = true;      ///< false: draw static parts again in every frame
    bool pixelCentres =
        false;  ///< camera samples lie at pixel centres, not at one random place of the pixel each; their times stay
    std::optional<CameraPose> cameraPose;  ///< replaces the scene's camera; static during the shutter
};

/// The times at which the scene is evaluated for the request's frame.
ShutterTimes shutterTimes(const Scene& scene, const FrameRequest& request);

inline constexpr int maximumSamplesPerPixel = 32;
inline constexpr int maximumImageSide = 16384;

}  // namespace timeshade
