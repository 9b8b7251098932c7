#include "window/moment_key.h"

namespace timeshade {

namespace {

void addLight(const LightChange& light, std::vector<double>& key) {
    const LightDirection direction = light.direction.value_or(LightDirection{});
    key.insert(key.end(), {double(light.direction.has_value()), direction.azimuth, direction.elevation,
                           light.distance.value_or(-1.0), light.cone.value_or(-1.0), light.intensity, light.move.x,
                           light.move.y, light.move.z, light.turn, light.rise});
}

}  // namespace

std::vector<double> momentKeyOf(const FrameRequest& request) {
    const Shutter& shutter = request.shutter;
    std::vector<double> key{request.frame,
                            shutter.framesPerSecond,
                            shutter.length,
                            double(shutter.position),
                            double(shutter.response),
                            shutter.width,
                            double(request.motionSteps),
                            double(request.looping),
                            double(request.cameraIndex)};
    addLight(request.light, key);
    if (!request.cameraPose) return key;
    const CameraPose& pose = *request.cameraPose;
    const auto append = [&](const glm::dvec3& v) { key.insert(key.end(), {v.x, v.y, v.z}); };
    append(pose.eye);
    for (int i = 0; i < 3; ++i) append(pose.axes[i]);
    key.insert(key.end(), {pose.verticalFieldOfView, pose.nearDistance});
    return key;
}

}  // namespace timeshade
