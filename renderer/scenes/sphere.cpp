#include "scenes/sphere.h"

#include <cmath>

#include "scenes/staging.h"

namespace timeshade {

namespace {

constexpr int frames = 240;
constexpr double framesPerSecond = 24.0;
constexpr double groundSide = 30.0;
const glm::dvec3 radii(2.3, 1.95, 1.7);

}  // namespace

const RecipeDescription& Sphere::description() const {
    static const RecipeDescription description{
        "sphere", "a round stone of 20,480 triangles that flies and turns: its lit side has no shadow of its own"};
    return description;
}

void Sphere::visitSettings(SettingsVisitor& visitor) {
    visitor.whole("frequency", frequency_, 32.0, 2.0, 128.0, "divisions",
                  "Into how many parts the edges of an icosahedron are divided; 20 times its square triangles.");
    visitor.number("speed", speed_, 0.5, 0.0, 4.0, "units per frame",
                   "How far the stone flies in one frame; its radius is about 2.");
    visitor.number("turn", turn_, 7.5, 0.0, 30.0, "degrees per frame",
                   "How far the stone turns in one frame, to a step of 1.5.");
}

std::unique_ptr<Scene> Sphere::make() {
    SceneParts parts;
    parts.name = description().name;
    parts.defaults = {12.0, framesPerSecond, 1.0};
    parts.parameters = parametersOf(*this);
    parts.materials = {matt("ground", {0.46f, 0.45f, 0.43f}, 0.95f), matt("stone", {0.80f, 0.68f, 0.50f}, 0.7f)};
    parts.instances.push_back(ground(groundSide, 0));

    const Circle circle = Circle::withChord(static_cast<double>(speed_), 2.4, frames);
    const int turns = static_cast<int>(std::lround(static_cast<double>(turn_) * frames / 360.0));
    MeshInstance stone;
    stone.shape = std::make_shared<const Shape>(stretched(geodesicSphere(frequency_), radii));
    stone.material = 1;
    const auto poseAt = [circle, turns](double seconds) {
        const double round = 2.0 * pi * seconds * framesPerSecond / frames, angle = round * circle.rounds;
        const glm::dvec3 way(std::cos(angle), 0.35 * std::sin(angle), std::sin(angle));
        return RigidPose{glm::dvec3(0.0, 4.4, 0.0) + circle.radius * way,
                         turnAbout(glm::normalize(glm::dvec3(0.5, 1.0, 0.3)), round * turns)};
    };
    stone.pose = poseAt(0.0);
    if (circle.rounds > 0 || turns > 0) {
        stone.motion = poseAt;
        parts.duration = frames / framesPerSecond;
    }
    parts.instances.push_back(std::move(stone));
    parts.cameras.emplace_back("beside", staticCamera({4.0, 11.0, 17.0}, {0.3, 2.9, 0.0}, 0.62));
    parts.cameras.emplace_back("near", staticCamera({1.5, 8.0, 12.0}, {0.4, 4.2, 0.6}, 0.5));
    parts.light = staticSpot({-8.0, 17.0, 7.0}, {0.0, 2.5, 0.0}, 0.46, 0.56);
    parts.bounds.add(glm::dvec3(-0.5 * groundSide, 0.0, -0.5 * groundSide));
    parts.bounds.add(glm::dvec3(0.5 * groundSide, 4.4 + 2.4 * 0.35 * 1.3 + radii.x, 0.5 * groundSide));
    return std::make_unique<MeshScene>(std::move(parts));
}

}  // namespace timeshade
