#pragma once

#include <optional>
#include <string>

#include "plan/frame_request.h"
#include "scene/camera.h"
#include "scene/ground.h"
#include "scene/light_change.h"

namespace CLI {
class App;
}

namespace timeshade {

/// One frame of a scene: its moment and shutter, its camera, and how finely it is sampled. Same for every technique.
struct FrameOptions {
    int width = 640, height = 480;  ///< pixels
    bool sizeGiven = false;         ///< they are not a command's own
    CameraSamples samples = CameraSamples::Strata;
    int samplesPerPixel = 8;
    int timeStrata = 8;  ///< of interval samples
    MapSize mapSize;     ///< of the shadow map
    unsigned seed = 1;
    std::string clip;                       ///< name of one of the file's animations; empty for the first
    std::optional<double> frame;            ///< the scene's own where not given
    std::optional<double> seconds;          ///< instead of a frame number
    std::optional<double> framesPerSecond;  ///< the scene's own where not given
    std::optional<double> shutterLength;    ///< frames; the scene's own where not given
    std::optional<double> instant;          ///< one instant of the shutter, u in [0, 1], instead of all of it
    int motionSteps = 1;                    ///< linear pieces of the shutter: a power of two
    Looping looping = Looping::Auto;
    ShutterPosition shutterPosition = ShutterPosition::Start;
    ShutterResponse shutterResponse = ShutterResponse::Box;
    std::optional<double> shutterWidth;  ///< of the Gaussian alone; Shutter's own where not given
    std::string camera;                  ///< name of one of the scene's cameras; empty for the first
    std::optional<CameraPose> pose;      ///< instead: a static camera of one's own
    std::string lightName;               ///< as GltfOptions::light; empty for the usual one
    LightChange light;
    GroundSettings ground;
    DisplayLook look;
    bool pixelCentres = false;                   ///< camera samples at pixel centres
    bool forceDynamic = false, noCache = false;  ///< yardsticks for what the plan and the caches save
};

/// Declares the options of a frame on a command. Both must live until the command line is parsed.
void declareOptions(CLI::App& app, FrameOptions& options);

}  // namespace timeshade
