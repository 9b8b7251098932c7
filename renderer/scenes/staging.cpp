#include "scenes/staging.h"

#include <algorithm>
#include <cmath>

#include "shared/hash.shared.h"

namespace timeshade {

Material matt(std::string name, const glm::vec3& colour, float roughness) {
    Material material;
    material.name = std::move(name);
    material.baseColorFactor = glm::vec4(colour, 1.0f);
    material.metallicFactor = 0.0f;
    material.roughnessFactor = roughness;
    return material;
}

MeshInstance ground(double side, std::uint32_t material) {
    MeshInstance instance;
    instance.shape = std::make_shared<const Shape>(plane(side, side, 8));
    instance.material = material;
    return instance;
}

std::function<LightPose(double)> staticSpot(const glm::dvec3& position, const glm::dvec3& target, double innerCone,
                                            double outerCone) {
    LightPose pose;
    pose.position = position;
    pose.axes = lookAt(position, target, glm::dvec3(0.0, 1.0, 0.0), 1.0, 1.0).axes;
    pose.intensity = glm::dvec3(1.0, 0.96, 0.88) * glm::dot(target - position, target - position);
    pose.innerConeAngle = innerCone;
    pose.outerConeAngle = outerCone;
    return [pose](double) { return pose; };
}

std::function<CameraPose(double)> staticCamera(const glm::dvec3& eye, const glm::dvec3& target,
                                               double verticalFieldOfView) {
    const CameraPose pose = lookAt(eye, target, glm::dvec3(0.0, 1.0, 0.0), verticalFieldOfView, 0.05);
    return [pose](double) { return pose; };
}

glm::dmat3 turnAbout(const glm::dvec3& axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const glm::dmat3 cross(0.0, axis.z, -axis.y, -axis.z, 0.0, axis.x, axis.y, -axis.x, 0.0);
    return c * glm::dmat3(1.0) + s * cross + (1.0 - c) * glm::outerProduct(axis, axis);
}

double backAndForth(double phase) {
    const double share = phase - std::floor(phase);
    return 2.0 * std::min(share, 1.0 - share);
}

Circle Circle::withChord(double chord, double wantedRadius, int frames) {
    if (!(chord > 0.0)) return {};
    const double angle = 2.0 * std::asin(std::min(1.0, chord / (2.0 * wantedRadius)));
    const int rounds = std::clamp(static_cast<int>(std::lround(angle * frames / (2.0 * pi))), 1, frames / 2);
    return {rounds, chord / (2.0 * std::sin(pi * rounds / frames))};
}

double Dice::share() { return shared::unitInterval(shared::hashWords({seed_, thing_, property_++}).x); }

glm::dvec3 Dice::direction() {
    const double height = between(-1.0, 1.0), angle = between(0.0, 2.0 * pi);
    const double radius = std::sqrt(std::max(0.0, 1.0 - height * height));
    return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

}  // namespace timeshade
