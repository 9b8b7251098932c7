#include "frame_setup.h"

#include <fmt/format.h>

#include "core/error.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

FrameRequest requestOfShutter(const Options& options, const Scene& scene) {
    FrameRequest request;
    request.width = options.width;
    request.height = options.height;
    request.samplesPerPixel = options.samplesPerPixel;
    request.mapSize = options.mapSize;
    request.seed = options.seed;
    request.forceDynamic = options.forceDynamic;
    request.useCaches = !options.noCache;
    request.shutter.framesPerSecond = options.framesPerSecond.value_or(scene.defaults().framesPerSecond);
    request.shutter.length = options.shutterLength.value_or(scene.defaults().shutterLength);
    request.shutter.position = options.shutterPosition;
    request.frame = options.seconds ? *options.seconds * request.shutter.framesPerSecond
                                    : options.frame.value_or(scene.defaults().frame);
    request.cameraPose = options.pose;
    if (options.camera.empty()) return request;
    std::string known;
    for (std::size_t i = 0; i < scene.cameras().size(); ++i) {
        if (scene.cameras()[i].name == options.camera) {
            request.cameraIndex = i;
            return request;
        }
        known += (i == 0 ? "" : ", ") + scene.cameras()[i].name;
    }
    throw UsageError(
        fmt::format("--camera {}: {} has no such camera; expected one of {}", options.camera, scene.name(), known));
}

}  // namespace

FrameRequest requestFor(const Options& options, const Scene& scene) {
    const FrameRequest request = requestOfShutter(options, scene);
    return options.instant ? atInstant(request, *options.instant) : request;
}

FrameRequest atInstant(const FrameRequest& request, double u) {
    FrameRequest instant = request;
    const double open = request.shutter.openSeconds(request.frame), close = request.shutter.closeSeconds(request.frame);
    instant.shutter.length = 0.0;
    instant.shutter.position = ShutterPosition::Start;
    instant.frame = (open + (close - open) * u) * request.shutter.framesPerSecond;
    return instant;
}

std::unique_ptr<Technique> techniqueFor(const Options& options, gl::ProgramCache& programs) {
    std::unique_ptr<Technique> technique = makeTechnique(options.technique, programs);
    const std::string prefix = options.technique + ".";
    for (const auto& [name, value] : options.settings)
        if (name.rfind(prefix, 0) == 0) setFromText(*technique, name.substr(prefix.size()), value);
    return technique;
}

}  // namespace timeshade
