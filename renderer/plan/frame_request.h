#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "plan/display_look.h"
#include "plan/map_size.h"
#include "scene/camera.h"
#include "scene/light_change.h"
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
    /// A power of two, 1 .. maximumMotionSteps: into how many equal pieces the shutter is cut, in each of which all
    /// motion is linear. Interval samples take 1 (checked).
    int motionSteps = 1;
    Looping looping = Looping::Auto;
    std::size_t cameraIndex = 0;
    bool forceDynamic = false;  ///< treat every triangle as dynamic, cull no unseen shadow, cache nothing
    bool useCaches = true;      ///< false: draw static parts again in every frame
    bool pixelCentres =
        false;  ///< camera samples lie at pixel centres, not at one random place of the pixel each; their times stay
    std::optional<CameraPose> cameraPose;  ///< replaces the scene's camera; static during the shutter
    LightChange light;
    DisplayLook look;  ///< of what screens show; radiance, and whatever is measured of it, does not know it
};

/// The times at which the scene is evaluated for the request's frame, or for one of so many pieces of its shutter.
ShutterTimes shutterTimes(const Scene& scene, const FrameRequest& request, int piece = 0, int pieces = 1);

/// The steps that the request's frame is drawn with: each piece has the same number of samples per pixel, so that they
/// are the largest power of two up to motionSteps that divides those. 1 where the shutter does not open.
int motionStepsOf(const FrameRequest& request);

/// Where they are fewer than motionSteps for the sake of the samples: so, in one line.
std::optional<std::string> loweredMotionSteps(const FrameRequest& request);

inline constexpr int maximumSamplesPerPixel = 32;
inline constexpr int maximumMotionSteps = maximumSamplesPerPixel;  ///< a piece has one sample per pixel at least
inline constexpr int maximumImageSide = 16384;

}  // namespace timeshade
