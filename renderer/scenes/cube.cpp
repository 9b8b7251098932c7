#include "scenes/cube.h"

#include <algorithm>
#include <cmath>

#include "scenes/staging.h"

namespace timeshade {

namespace {

constexpr int frames = 6;  // three there, three back
constexpr int defaultFrame = 1;
constexpr double framesPerSecond = 24.0;
constexpr double cubeSide = 2.0;
constexpr double height = 3.6;  // of the cube's centre
constexpr double planeSide = 18.0;
const glm::dvec3 lightPlace(-5.0, 15.0, 4.0);

/// From -1.5 to 1.5 frames of motion and back; 0 at the centre of the default frame.
double framesMoved(double seconds) {
    constexpr double there = 0.5 * frames;
    return there * backAndForth(seconds * framesPerSecond / frames) - 0.5 * there;
}

}  // namespace

const RecipeDescription& Cube::description() const {
    static const RecipeDescription description{
        "cube", "a cube that moves above a plane, which stands still or turns: a shadow on a receiver of either kind"};
    return description;
}

void Cube::visitSettings(SettingsVisitor& visitor) {
    visitor.number("speed", speed_, 1.0, 0.0, 3.0, "cube sides per frame", "How far the cube moves in one frame.");
    visitor.toggle("turning", turning_, false, "The plane turns about an axis in it.");
    visitor.number("angle", angle_, 8.0, 0.0, 16.0, "degrees per frame", "How far the plane turns in one frame.");
}

std::unique_ptr<Scene> Cube::make() {
    SceneParts parts;
    parts.name = description().name;
    parts.defaults = {static_cast<double>(defaultFrame), framesPerSecond, 1.0};
    const double way = cubeSide * static_cast<double>(speed_),
                 angle = turning_ ? glm::radians(static_cast<double>(angle_)) : 0.0;
    parts.duration = way > 0.0 || angle > 0.0 ? frames / framesPerSecond : 0.0;
    parts.parameters = parametersOf(*this);
    parts.materials = {matt("plane", {0.46f, 0.45f, 0.43f}, 0.95f), matt("cube", {0.60f, 0.20f, 0.04f})};

    const glm::dvec3 axis(0.0, 0.0, 1.0);
    MeshInstance board = ground(planeSide, 0);
    if (angle > 0.0)
        board.motion = [=](double seconds) {
            return RigidPose{glm::dvec3(0.0), turnAbout(axis, angle * framesMoved(seconds))};
        };
    parts.instances.push_back(std::move(board));

    MeshInstance cube;
    cube.shape = std::make_shared<const Shape>(box(glm::dvec3(cubeSide), {1, 1, 1}));
    cube.material = 1;
    const RigidPose middle{{0.0, height, 0.0}, turnAbout({0.0, 1.0, 0.0}, 0.4)};
    cube.pose = middle;
    if (way > 0.0)
        cube.motion = [=](double seconds) {
            return RigidPose{middle.position + glm::dvec3(way * framesMoved(seconds), 0.0, 0.0), middle.axes};
        };
    parts.instances.push_back(std::move(cube));

    parts.cameras.emplace_back("beside", staticCamera({3.0, 10.5, 14.0}, {0.8, 1.2, 0.0}, 0.62));
    parts.cameras.emplace_back("grazing", staticCamera({9.0, 3.6, 12.0}, {0.6, 1.4, 0.0}, 0.6));
    parts.light = staticSpot(lightPlace, {0.6, 0.0, 0.0}, 0.50, 0.58);
    const double low = 0.5 * planeSide * std::sin(1.5 * angle);
    parts.bounds.add(glm::dvec3(-0.5 * planeSide - 1.5 * way, -low, -0.5 * planeSide));
    parts.bounds.add(glm::dvec3(0.5 * planeSide + 1.5 * way, std::max(low, height + cubeSide), 0.5 * planeSide));
    return std::make_unique<MeshScene>(std::move(parts));
}

}  // namespace timeshade
