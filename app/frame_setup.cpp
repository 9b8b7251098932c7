#include "frame_setup.h"

#include <fmt/format.h>

#include "core/error.h"
#include "options/light_options.h"
#include "standard_error.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

FrameRequest requestOfShutter(const FrameOptions& options, const Scene& scene) {
    FrameRequest request;
    request.width = options.width;
    request.height = options.height;
    request.samples = options.samples;
    request.samplesPerPixel = options.samplesPerPixel;
    request.timeStrata = options.timeStrata;
    request.mapSize = options.mapSize;
    request.seed = options.seed;
    request.forceDynamic = options.forceDynamic;
    request.useCaches = !options.noCache;
    request.pixelCentres = options.pixelCentres;
    request.motionSteps = options.motionSteps;
    if (request.motionSteps > 1 && request.samples == CameraSamples::Intervals)
        throw UsageError(
            fmt::format("--motion-steps {}: interval samples take one linear motion; expected --samples strata",
                        request.motionSteps));
    request.looping = options.looping;
    request.shutter.framesPerSecond = options.framesPerSecond.value_or(scene.defaults().framesPerSecond);
    request.shutter.length = options.shutterLength.value_or(scene.defaults().shutterLength);
    request.shutter.position = options.shutterPosition;
    request.shutter.response = options.shutterResponse;
    if (options.shutterWidth && options.shutterResponse != ShutterResponse::Gaussian)
        throw UsageError(
            fmt::format("--shutter-width {}: no other response has a width; expected with --shutter-response gaussian",
                        *options.shutterWidth));
    request.shutter.width = options.shutterWidth.value_or(request.shutter.width);
    request.frame = options.seconds ? *options.seconds * request.shutter.framesPerSecond
                                    : options.frame.value_or(scene.defaults().frame);
    request.cameraPose = options.pose;
    requireLightHas(lightAtOwnFrame(scene), options.light, scene.name());
    request.light = options.light;
    request.look = options.look;
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

SceneChoice choiceOf(const FrameOptions& options) { return {options.clip, options.lightName, options.ground}; }

FrameRequest requestFor(const FrameOptions& options, const Scene& scene) {
    const FrameRequest request = requestOfShutter(options, scene);
    if (const std::optional<std::string> lowered = loweredMotionSteps(request)) tellNote(*lowered);
    return options.instant ? atInstant(request, *options.instant) : request;
}

void requireStrata(const FrameOptions& options, const std::string& what) {
    if (options.samples == CameraSamples::Intervals)
        throw UsageError(
            fmt::format("--samples intervals: {} needs camera samples that have a time each; expected strata", what));
}

void requireOneMotionStep(const FrameOptions& options, const std::string& what) {
    if (options.motionSteps > 1)
        throw UsageError(
            fmt::format("--motion-steps {}: {} takes one linear motion; expected 1", options.motionSteps, what));
}

void setResponse(FrameOptions& options, const Shutter& shutter) {
    const bool hasWidth = shutter.response == ShutterResponse::Gaussian && shutter.width != Shutter{}.width;
    options.shutterResponse = shutter.response;
    options.shutterWidth = hasWidth ? std::optional(shutter.width) : std::nullopt;
}

FrameRequest atInstant(const FrameRequest& request, double u) {
    FrameRequest instant = request;
    const double open = request.shutter.openSeconds(request.frame), close = request.shutter.closeSeconds(request.frame);
    instant.motionSteps = 1;
    instant.shutter.length = 0.0;
    instant.shutter.position = ShutterPosition::Start;
    instant.frame = (open + (close - open) * u) * request.shutter.framesPerSecond;
    return instant;
}

std::unique_ptr<Technique> techniqueFor(const std::string& name, const SettingTexts& settings,
                                        gl::ProgramCache& programs) {
    std::unique_ptr<Technique> technique = makeTechnique(name, programs);
    const std::string prefix = name + ".";
    for (const auto& [key, value] : settings)
        if (key.starts_with(prefix)) setFromText(*technique, key.substr(prefix.size()), value);
    return technique;
}

std::unique_ptr<Technique> techniqueFor(const TechniqueOptions& options, gl::ProgramCache& programs) {
    return techniqueFor(options.technique, options.settings, programs);
}

}  // namespace timeshade
