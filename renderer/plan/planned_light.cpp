#include "plan/planned_light.h"

#include <algorithm>

namespace timeshade {

PlannedLight::PlannedLight(const Scene& scene, const FrameRequest& request, const ShutterTimes& times, int piece,
                           int pieces)
    : scene_(scene), change_(request.light), times_(times) {
    if (change_ == LightChange{}) return;
    atOwnFrame_ = lightAtOwnFrame(scene);
    const double rate = request.shutter.framesPerSecond, open = rate * request.shutter.openSeconds(request.frame),
                 close = rate * request.shutter.closeSeconds(request.frame);
    frames_ = (close - open) / pieces;
    firstFrame_ = open - scene.defaults().frame + frames_ * piece;
}

LightPose PlannedLight::changedAt(const LightPose& own, double u) const {
    if (change_ == LightChange{}) return own;
    return changed(own, atOwnFrame_, change_, scene_.bounds().centre(), firstFrame_ + frames_ * u);
}

ShutterEnds<LightPose> PlannedLight::ends() const {
    const ShutterEnds<LightPose> own = scene_.lightEnds(times_.open, times_.close);
    return {changedAt(own.open, 0.0), changedAt(own.close, 1.0)};
}

LightPose PlannedLight::middle() const { return changedAt(scene_.light(0.5 * (times_.open + times_.close)), 0.5); }

LightPose PlannedLight::at(double u) const {
    return changedAt(scene_.light(times_.open + u * (times_.close - times_.open)), u);
}

double exposureOf(const Scene& scene, const LightChange& change) {
    const LightPose own = lightAtOwnFrame(scene);
    LightChange placed;
    placed.direction = change.direction;
    placed.distance = change.distance;
    const LightPose light = placed.places() ? changed(own, own, placed, scene.bounds().centre(), 0.0) : own;
    const glm::dvec3 path = scene.bounds().centre() - light.position;
    const double squared = light.kind == LightKind::Directional ? 1.0 : std::max(glm::dot(path, path), 1e-12);
    double strongest = std::max({light.intensity.x, light.intensity.y, light.intensity.z, 1e-12});
    for (int i = 0; scene.duration() > 0.0 && i <= 64; ++i) {
        const glm::dvec3 then = scene.light(scene.duration() * i / 64).intensity;
        strongest = std::max({strongest, then.x, then.y, then.z});
    }
    return 2.6 * 3.14159265358979 * squared / strongest;
}

}  // namespace timeshade
