#include "window/moment_key.h"

namespace timeshade {

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
    if (!request.cameraPose) return key;
    const CameraPose& pose = *request.cameraPose;
    const auto append = [&](const glm::dvec3& v) { key.insert(key.end(), {v.x, v.y, v.z}); };
    append(pose.eye);
    for (int i = 0; i < 3; ++i) append(pose.axes[i]);
    key.insert(key.end(), {pose.verticalFieldOfView, pose.nearDistance});
    return key;
}

}  // namespace timeshade
