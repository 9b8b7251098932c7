#include "scenes/crossing.h"

#include <cmath>

#include "scenes/staging.h"

namespace timeshade {

namespace {

constexpr int frames = 6;  // three there, three back
constexpr int defaultFrame = 1;
constexpr double framesPerSecond = 24.0;
constexpr double quadSide = 2.4;
constexpr double lowerHeight = 1.8;
constexpr double groundSide = 40.0;
const glm::dvec3 lightPlace(-8.0, 21.0, 6.0);

/// A quad that is at `middle` at the centre of the default frame and moves by `way` in every frame.
MeshInstance passing(const std::shared_ptr<const Shape>& quad, std::uint32_t material, const glm::dvec3& middle,
                     const glm::dvec3& way) {
    MeshInstance instance;
    instance.shape = quad;
    instance.material = material;
    instance.pose = {middle};
    if (way != glm::dvec3(0.0))
        instance.motion = [middle, way](double seconds) {
            constexpr double there = 0.5 * frames;
            return RigidPose{middle + way * (there * backAndForth(seconds * framesPerSecond / frames) - 0.5 * there)};
        };
    return instance;
}

}  // namespace

const RecipeDescription& Crossing::description() const {
    static const RecipeDescription description{
        "crossing",
        "two quads that pass across each other at different distances: a moving shadow on a moving receiver"};
    return description;
}

void Crossing::visitSettings(SettingsVisitor& visitor) {
    visitor.number("angle", angle_, 90.0, 0.0, 180.0, "degrees", "The angle between the two motions.");
    visitor.number("speed", speed_, 1.0, 0.0, 4.0, "quad sides per frame", "How far each quad moves in one frame.");
    visitor.number("distance", distance_, 1.0, 0.05, 3.0, "quad sides", "How far the upper quad is above the lower.");
}

std::unique_ptr<Scene> Crossing::make() {
    SceneParts parts;
    parts.name = description().name;
    parts.defaults = {static_cast<double>(defaultFrame), framesPerSecond, 1.0};
    parts.duration = speed_ > 0.0f ? frames / framesPerSecond : 0.0;
    parts.parameters = parametersOf(*this);
    parts.materials = {matt("ground", {0.46f, 0.45f, 0.43f}, 0.95f), matt("lower", {0.20f, 0.46f, 0.15f}),
                       matt("upper", {0.60f, 0.20f, 0.04f})};
    parts.instances.push_back(ground(groundSide, 0));

    const auto quad = std::make_shared<const Shape>(plane(quadSide, quadSide, 1));
    const double way = quadSide * static_cast<double>(speed_);
    const double upperHeight = lowerHeight + quadSide * static_cast<double>(distance_);
    const double angle = glm::radians(static_cast<double>(angle_));
    const auto onAxis = [](double height) { return lightPlace * (height / lightPlace.y); };
    parts.instances.push_back(passing(quad, 1, onAxis(lowerHeight), {way, 0.0, 0.0}));
    parts.instances.push_back(
        passing(quad, 2, onAxis(upperHeight), {way * std::cos(angle), 0.0, way * std::sin(angle)}));

    parts.cameras.emplace_back("beside", staticCamera({4.4, 9.8, 9.4}, {-1.1, 1.3, 0.0}, 0.62));
    parts.cameras.emplace_back("above", staticCamera({2.0, 18.0, 4.0}, {-0.6, 0.0, 0.2}, 0.5));
    parts.light = staticSpot(lightPlace, {0.0, 0.0, 0.0}, 0.46, 0.54);
    parts.bounds.add(glm::dvec3(-0.5 * groundSide, 0.0, -0.5 * groundSide));
    parts.bounds.add(glm::dvec3(0.5 * groundSide, upperHeight, 0.5 * groundSide));
    return std::make_unique<MeshScene>(std::move(parts));
}

}  // namespace timeshade
