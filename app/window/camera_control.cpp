#include "window/camera_control.h"

#include <fmt/format.h>

namespace timeshade {

CameraPose CameraControl::pose(const Scene& scene, const Moment& moment) const {
    FrameRequest request = moment.request;
    request.frame = moment.playback.frame();
    return orbit ? orbit->pose() : scene.camera(request.cameraIndex, shutterTimes(scene, request).open);
}

OrbitCamera& CameraControl::take(const Scene& scene, const Moment& moment) {
    if (!orbit) orbit.emplace(pose(scene, moment), scene.bounds());
    return *orbit;
}

void CameraControl::useSceneCamera(Moment& moment, std::size_t index) {
    orbit.reset();
    moment.request.cameraIndex = index;
}

void CameraControl::save(const Scene& scene, const Moment& moment, const std::string& name) {
    savedViews.push_back({name.empty() ? fmt::format("View {}", savedViews.size() + 1) : name,
                          orbit ? *orbit : OrbitCamera(pose(scene, moment), scene.bounds())});
}

}  // namespace timeshade
