#include "scenes/frusta.h"

#include <cmath>

#include "scenes/staging.h"

namespace timeshade {

namespace {

constexpr int frames = 240;
constexpr double framesPerSecond = 24.0;
constexpr double groundSide = 150.0;
constexpr double firstRow = 3.0, lastRow = -52.0;  // z of the rows: towards the light
const glm::dvec3 eye(1.2, 5.6, 18.0), target(0.0, 0.0, -6.0);

Shape post() {
    return turned(
        {{0.0, -0.1}, {0.30, -0.1}, {0.30, 0.25}, {0.16, 0.35}, {0.14, 2.7}, {0.26, 2.85}, {0.26, 3.05}, {0.0, 3.2}},
        16);
}

Shape tree() {
    Shape shape = turned({{0.0, -0.1}, {0.17, -0.1}, {0.12, 1.5}, {0.0, 1.6}}, 12);
    for (int tier = 0; tier < 4; ++tier) {
        const double low = 0.75 + 0.85 * tier, radius = 1.25 - 0.25 * tier;
        shape.add(turned({{0.0, low + 0.12}, {radius, low}, {0.3 * radius, low + 0.95}, {0.0, low + 1.25}}, 14));
    }
    return shape;
}

/// A slow closed path on a small ellipse, looking at a fixed point.
CameraPose pathAt(double seconds, double speed) {
    const double angle = 2.0 * pi * seconds * framesPerSecond / frames;
    const double reach = speed * frames / (2.0 * pi);  // the speed of a point on a circle of this radius
    const glm::dvec3 place =
        eye + reach * glm::dvec3(0.7 * std::sin(angle), 0.08 * (1.0 - std::cos(angle)), 0.45 * (std::cos(angle) - 1.0));
    return lookAt(place, target + glm::dvec3(0.35 * reach * std::sin(angle), 0.0, 0.0), {0.0, 1.0, 0.0}, 0.72, 0.05);
}

}  // namespace

const RecipeDescription& Frusta::description() const {
    static const RecipeDescription description{
        "frusta",
        "rows of posts and trees against a low light that faces the camera; nothing moves but the camera 'path'"};
    return description;
}

void Frusta::visitSettings(SettingsVisitor& visitor) {
    visitor.whole("rows", rows_, 12.0, 1.0, 60.0, "rows",
                  "How many rows of posts and trees stand between the camera and the light.");
    visitor.number("speed", speed_, 0.125, 0.01, 1.0, "units per frame",
                   "About how far the camera 'path' flies in one frame at its fastest; a post is 3.2 units high.");
}

std::unique_ptr<Scene> Frusta::make() {
    SceneParts parts;
    parts.name = description().name;
    parts.defaults = {0.0, framesPerSecond, 0.5};
    parts.duration = frames / framesPerSecond;
    parts.parameters = parametersOf(*this);
    parts.materials = {matt("ground", {0.62f, 0.57f, 0.47f}, 0.95f), matt("post", {0.70f, 0.68f, 0.64f}, 0.8f),
                       matt("fir", {0.34f, 0.52f, 0.30f}, 0.9f), matt("pale fir", {0.48f, 0.58f, 0.34f}, 0.9f)};
    parts.instances.push_back(ground(groundSide, 0));
    const auto posts = std::make_shared<const Shape>(post());
    std::vector<std::shared_ptr<const Shape>> trees;
    for (const double size : {0.8, 1.0, 1.2})
        trees.push_back(std::make_shared<const Shape>(stretched(tree(), glm::dvec3(size))));
    for (int row = 0; row < rows_; ++row) {
        const double z = rows_ == 1 ? firstRow : firstRow + (lastRow - firstRow) * row / (rows_ - 1);
        for (int column = -5; column <= 5; ++column) {
            Dice dice(7u, static_cast<std::uint32_t>(row * 16 + column + 8));
            const bool isPost = (row + column) % 2 == 0;
            MeshInstance instance;
            instance.shape = isPost ? posts : trees[dice.below(static_cast<std::uint32_t>(trees.size()))];
            instance.material = isPost ? 1 : 2 + dice.below(2);
            instance.pose.position = {
                3.4 * column + (isPost ? 0.0 : dice.between(-0.7, 0.7)) + (row % 2 == 0 ? 0.0 : 1.1), 0.0, z};
            instance.pose.axes = turnAbout({0.0, 1.0, 0.0}, dice.between(0.0, 2.0 * pi));
            parts.instances.push_back(std::move(instance));
        }
    }
    const double speed = speed_;
    parts.cameras.emplace_back("still", [](double) { return pathAt(0.0, 0.0); });
    parts.cameras.emplace_back("path", [speed](double seconds) { return pathAt(seconds, speed); });
    parts.light = staticSpot({4.0, 17.0, -72.0}, {0.0, -4.0, 0.0}, 0.40, 0.48);
    parts.bounds.add(glm::dvec3(-0.5 * groundSide, -0.2, -0.5 * groundSide));
    parts.bounds.add(glm::dvec3(0.5 * groundSide, 6.5, 0.5 * groundSide));
    return std::make_unique<MeshScene>(std::move(parts));
}

}  // namespace timeshade
