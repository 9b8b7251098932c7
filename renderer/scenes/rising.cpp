#include "scenes/rising.h"

#include <cmath>

#include "scenes/staging.h"

namespace timeshade {

namespace {

constexpr int frames = 24;
constexpr int defaultFrame = 8;  // half-way up, at the fastest
constexpr double framesPerSecond = 24.0;
constexpr double cubeSide = 2.4;
constexpr double groundSide = 40.0;
constexpr double lightHeight = 34.0;

}  // namespace

const RecipeDescription& Rising::description() const {
    static const RecipeDescription description{
        "rising", "two finely divided cubes that rise towards a light overhead: 12,000 moving triangles"};
    return description;
}

void Rising::visitSettings(SettingsVisitor& visitor) {
    visitor.number("speed", speed_, 0.5, 0.0, 1.0, "cube sizes per frame",
                   "How far the cubes rise in the frame in which they are fastest; they sink again as fast.");
}

std::unique_ptr<Scene> Rising::make() {
    SceneParts parts;
    parts.name = description().name;
    parts.defaults = {static_cast<double>(defaultFrame), framesPerSecond, 1.0};
    parts.duration = speed_ > 0.0f ? frames / framesPerSecond : 0.0;
    parts.parameters = parametersOf(*this);
    parts.materials = {matt("ground", {0.46f, 0.45f, 0.42f}, 0.95f), matt("brick", {0.78f, 0.36f, 0.24f}),
                       matt("slate", {0.30f, 0.46f, 0.58f})};
    parts.instances.push_back(ground(groundSide, 0));

    // 18 x 20 x 30 cells: no finer cube of equal cells has 6,000 triangles.
    const auto cube = std::make_shared<const Shape>(box(glm::dvec3(cubeSide), {18, 30, 20}));
    const double swing = static_cast<double>(speed_) * cubeSide * frames / (2.0 * pi);
    const glm::dvec3 places[] = {{-2.9, 1.1 * cubeSide + swing, 0.6}, {2.4, 1.4 * cubeSide + swing, -1.0}};
    for (std::uint32_t i = 0; i < 2; ++i) {
        MeshInstance instance;
        instance.shape = cube;
        instance.material = 1 + i;
        const RigidPose middle{places[i], turnAbout({0.0, 1.0, 0.0}, 0.35 + 0.5 * i)};
        instance.pose = middle;
        if (speed_ > 0.0f)
            instance.motion = [middle, swing](double seconds) {
                RigidPose pose = middle;
                pose.position.y +=
                    swing * std::sin(2.0 * pi * (seconds * framesPerSecond - defaultFrame - 0.5) / frames);
                return pose;
            };
        parts.instances.push_back(std::move(instance));
    }
    parts.cameras.emplace_back("beside", staticCamera({10.0, 16.0, 25.0}, {0.0, 4.6, 0.0}, 0.62));
    parts.cameras.emplace_back("above", staticCamera({3.0, 30.0, 10.0}, {0.0, 3.0, 0.0}, 0.56));
    parts.light = staticSpot({0.0, lightHeight, 0.0}, {0.0, 0.0, 0.0}, 0.50, 0.58);
    parts.bounds.add(glm::dvec3(-0.5 * groundSide, 0.0, -0.5 * groundSide));
    parts.bounds.add(glm::dvec3(0.5 * groundSide, 2.0 * swing + 2.5 * cubeSide, 0.5 * groundSide));
    return std::make_unique<MeshScene>(std::move(parts));
}

}  // namespace timeshade
