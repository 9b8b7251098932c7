#pragma once

#include <cstdint>
#include <optional>

#include "scene/camera.h"
#include "scene/shutter.h"

namespace timeshade {

/// Everything about a frame that does not depend on the technique. Two equal requests for one scene give equal
/// frames.
struct FrameRequest {
    int width = 640;  ///< pixels, 1 .. 16384
    int height = 480;
    int samplesPerPixel = 8;  ///< 1 .. 32, one per stratum of the shutter
    int mapSize = 1024;       ///< texels along a side of the light's map, 16 .. 8192
    std::uint32_t seed = 1;
    double frame = 0.0;  ///< number of the frame; whole numbers unless scrubbing
    Shutter shutter;
    std::size_t cameraIndex = 0;
    bool forceDynamic =
        false;  ///< every triangle is treated as dynamic, none is culled for what nobody sees, nothing is cached
    bool useCaches = true;                 ///< false: what is static is drawn again in every frame
    std::optional<CameraPose> cameraPose;  ///< replaces the scene's camera (held still over the shutter)
};

inline constexpr int maximumSamplesPerPixel = 32;
inline constexpr int minimumMapSize = 16;
inline constexpr int maximumMapSize = 8192;
inline constexpr int maximumImageSide = 16384;

}  // namespace timeshade
