#include "scenes/foliage.h"

#include <algorithm>
#include <cmath>

#include "scenes/staging.h"

namespace timeshade {

namespace {

constexpr int frames = 24;
constexpr double framesPerSecond = 24.0;
constexpr double groundSide = 24.0;
constexpr double leafWidth = 1.1, leafLength = 1.8;
constexpr double lowest = 1.7, highest = 4.2, reach = 3.4;  // of stalks
constexpr int imageSide = 128;

/// How far inside the leaf a place of its card is, in shares of the card; negative outside. The stalk is at (0, -1).
double insideLeaf(double x, double y) {
    const double along = 0.5 * (y + 1.0);
    const double teeth = 1.0 - 0.12 * std::abs(std::sin(9.0 * pi * along));
    const double halfWidth = 0.92 * std::pow(std::sin(pi * std::pow(along, 0.75)), 0.8) * teeth;
    double inside = std::min(halfWidth - std::abs(x), 0.98 - std::abs(y));
    inside = std::max(inside, along < 0.3 ? 0.06 - std::abs(x) : -1.0);
    for (const glm::dvec3& hole : {glm::dvec3(0.3, 0.1, 0.13), glm::dvec3(-0.35, -0.25, 0.1)})
        inside = std::min(inside, std::hypot(x - hole.x, y - hole.y) - hole.z);
    return inside;
}

Image leaf() {
    Image image{"leaf", imageSide, imageSide, {}};
    for (int row = 0; row < imageSide; ++row)
        for (int column = 0; column < imageSide; ++column) {
            const double x = (2.0 * column + 1.0) / imageSide - 1.0, y = (2.0 * row + 1.0) / imageSide - 1.0;
            const double rib = std::abs(x) < 0.03 || std::abs(std::remainder(y - 0.7 * std::abs(x), 0.3)) < 0.025;
            const double alpha = std::clamp(0.5 + 12.0 * insideLeaf(x, y), 0.0, 1.0);
            image.rgba.push_back(static_cast<std::uint8_t>(rib ? 168 : 112));
            image.rgba.push_back(static_cast<std::uint8_t>(rib ? 190 : 158));
            image.rgba.push_back(static_cast<std::uint8_t>(rib ? 96 : 62));
            image.rgba.push_back(static_cast<std::uint8_t>(std::lround(255.0 * alpha)));
        }
    return image;
}

/// From its stalk, which is where the card's side of the least z has its middle.
Shape leafShape() {
    Shape shape = plane(leafWidth, leafLength, 1);
    for (glm::dvec3& position : shape.positions) position.z += 0.5 * leafLength;
    return shape;
}

}  // namespace

const RecipeDescription& Foliage::description() const {
    static const RecipeDescription description{
        "foliage", "leaves, cut out of cards by their alpha, that sway under a sun that moves"};
    return description;
}

void Foliage::visitSettings(SettingsVisitor& visitor) {
    visitor.whole("count", count_, 40, 1, 400, "leaves", "How many leaves there are.");
    visitor.number("sway", sway_, 8.0, 0.0, 30.0, "degrees", "How far each leaf sways to either side.");
    visitor.number("sun", sun_, 3.0, 0.0, 10.0, "degrees per frame", "How far the sun moves in one frame.");
    visitor.whole("seed", seed_, 1, 1, 1000, "seed", "Another number is another arrangement of all leaves.");
}

std::unique_ptr<Scene> Foliage::make() {
    SceneParts parts;
    parts.name = description().name;
    parts.defaults = {3.0, framesPerSecond, 1.0};
    parts.duration = sway_ > 0.0f || sun_ > 0.0f ? frames / framesPerSecond : 0.0;
    parts.parameters = parametersOf(*this);
    parts.materials = {matt("ground", {0.46f, 0.45f, 0.43f}, 0.95f), matt("leaf", glm::vec3(1.0f), 0.6f)};
    parts.images.push_back(leaf());
    Material& leaves = parts.materials.back();
    leaves.doubleSided = true;
    leaves.baseColor = {.image = 0, .wrapU = Wrap::Clamp, .wrapV = Wrap::Clamp};
    leaves.cutout = Cutout{.threshold = cutoutThreshold(0.5, 1.0)};
    parts.instances.push_back(ground(groundSide, 0));

    const auto shape = std::make_shared<const Shape>(leafShape());
    for (int i = 0; i < count_; ++i) {
        Dice dice(static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(i));
        const double angle = dice.between(0.0, 2.0 * pi), away = reach * std::sqrt(dice.share());
        const glm::dvec3 stalk(away * std::cos(angle), dice.between(lowest, highest), away * std::sin(angle));
        const glm::dmat3 heading = turnAbout({0.0, 1.0, 0.0}, dice.between(0.0, 2.0 * pi));
        const double droop = dice.between(-0.3, 0.9), roll = dice.between(-0.5, 0.5), phase = dice.share();
        const double most = glm::radians(static_cast<double>(sway_));
        const auto poseAt = [=](double seconds) {
            const double swing = most * std::sin(2.0 * pi * (seconds * framesPerSecond / frames + phase));
            return RigidPose{stalk, heading * turnAbout({1.0, 0.0, 0.0}, droop + swing) *
                                        turnAbout({0.0, 0.0, 1.0}, roll + 0.5 * swing)};
        };
        MeshInstance instance;
        instance.shape = shape;
        instance.material = 1;
        instance.pose = poseAt(0.0);
        if (sway_ > 0.0f) instance.motion = poseAt;
        parts.instances.push_back(std::move(instance));
    }

    const double turn = glm::radians(static_cast<double>(sun_));
    parts.light = [turn](double seconds) {
        // There and back, between 12 frames' turn.
        const double angle = turn * 0.5 * frames * (backAndForth(seconds * framesPerSecond / frames) - 0.5);
        LightPose pose;
        pose.kind = LightKind::Directional;
        const glm::dvec3 towards = turnAbout({0.0, 0.0, 1.0}, angle) * glm::normalize(glm::dvec3(0.35, 1.0, 0.25));
        pose.axes = lookAt(towards, glm::dvec3(0.0), glm::dvec3(0.0, 0.0, 1.0), 1.0, 1.0).axes;
        pose.intensity = {1.0, 0.96, 0.88};
        return pose;
    };
    parts.cameras.emplace_back("beside", staticCamera({5.2, 6.4, 8.2}, {0.0, 1.2, 0.0}, 0.72));
    parts.cameras.emplace_back("above", staticCamera({0.5, 14.0, 4.0}, {0.0, 0.0, 0.0}, 0.62));
    parts.bounds.add(glm::dvec3(-0.5 * groundSide, -leafLength, -0.5 * groundSide));
    parts.bounds.add(glm::dvec3(0.5 * groundSide, highest + leafLength, 0.5 * groundSide));
    return std::make_unique<MeshScene>(std::move(parts));
}

}  // namespace timeshade
