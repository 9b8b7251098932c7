#include "scenes/depths.h"

#include "scenes/staging.h"

namespace timeshade {

namespace {

constexpr int frames = 3;  // one and a half there, as many back
constexpr double framesPerSecond = 24.0;
constexpr double lowerSide = 2.0, upperSide = 1.3;
constexpr double leastGap = 0.2;  // between the lower quad and the ground, along its ray
constexpr double groundSide = 24.0;
const glm::dvec3 lightPlace(-3.0, 8.8, 2.4);
/// Where the rays of the light meet the ground on which the centres of the lower and of the upper quad move.
const glm::dvec3 lowerFoot(0.0, 0.0, 0.0), upperFoot(1.0, 0.0, 0.5);

}  // namespace

const RecipeDescription& Depths::description() const {
    static const RecipeDescription description{
        "depths",
        "two quads: the lower one moves towards the light, the upper one away from it, and shadows the lower one"};
    return description;
}

void Depths::visitSettings(SettingsVisitor& visitor) {
    visitor.number("speed", speed_, 0.7, 0.0, 1.0, "lower quad sides per frame",
                   "How far each quad moves in one frame.");
    visitor.number("distance", distance_, 0.2, 0.05, 0.8, "lower quad sides",
                   "How near the quads come to each other, where they turn back.");
}

std::unique_ptr<Scene> Depths::make() {
    SceneParts parts;
    parts.name = description().name;
    parts.defaults = {0.0, framesPerSecond, 1.0};
    parts.duration = speed_ > 0.0f ? frames / framesPerSecond : 0.0;
    parts.parameters = parametersOf(*this);
    parts.materials = {matt("ground", {0.46f, 0.45f, 0.43f}, 0.95f), matt("lower", {0.20f, 0.46f, 0.15f}),
                       matt("upper", {0.60f, 0.20f, 0.04f})};
    parts.instances.push_back(ground(groundSide, 0));

    const double travel = 0.5 * frames * lowerSide * static_cast<double>(speed_);
    const glm::dvec3 lowerRay = glm::normalize(lightPlace - lowerFoot);
    const glm::dvec3 upperRay = glm::normalize(lightPlace - upperFoot);
    const double meetingHeight =
        (leastGap + travel) * lowerRay.y + lowerSide * static_cast<double>(distance_);  // of the upper quad
    const double highest = meetingHeight / upperRay.y + travel;                         // along its ray
    for (const bool upper : {false, true}) {
        MeshInstance instance;
        const double side = upper ? upperSide : lowerSide;
        instance.shape = std::make_shared<const Shape>(plane(side, side, 1));
        instance.material = upper ? 2 : 1;
        const auto poseAt = [=](double seconds) {
            // A quarter of a frame of the way lies before the default frame.
            const double risen = travel * backAndForth((seconds * framesPerSecond + 0.25) / frames);
            return upper ? RigidPose{upperFoot + upperRay * (highest - risen)}
                         : RigidPose{lowerFoot + lowerRay * (leastGap + risen)};
        };
        instance.pose = poseAt(0.0);
        if (speed_ > 0.0f) instance.motion = poseAt;
        parts.instances.push_back(std::move(instance));
    }
    parts.cameras.emplace_back("beside", staticCamera({3.6, 6.0, 7.2}, {-0.4, 1.5, 0.0}, 0.64));
    parts.cameras.emplace_back("low", staticCamera({6.0, 3.0, 6.4}, {-0.4, 1.5, 0.2}, 0.6));
    parts.light = staticSpot(lightPlace, {0.0, 0.0, 0.0}, 0.46, 0.54);
    parts.bounds.add(glm::dvec3(-0.5 * groundSide, 0.0, -0.5 * groundSide));
    parts.bounds.add(glm::dvec3(0.5 * groundSide, highest * upperRay.y, 0.5 * groundSide));
    return std::make_unique<MeshScene>(std::move(parts));
}

}  // namespace timeshade
