#include "support/cutout_scene.h"

#include <algorithm>
#include <cmath>

#include "scenes/staging.h"

namespace timeshade {

namespace {

constexpr double duration = 2.0;  // there and back

std::shared_ptr<const Shape> card(double width, double depth, const CutoutSceneOptions& options) {
    Shape shape = plane(width, depth, 1);
    const float low = options.wrap == Wrap::Mirror ? -options.repeats : 0.0f;
    for (glm::vec2& t : shape.textureCoordinates) t = glm::vec2(low) + t * (options.repeats - low);
    return std::make_shared<const Shape>(std::move(shape));
}

std::shared_ptr<const Shape> sides(const CutoutSceneOptions& options) {
    Shape shape = box(glm::dvec3(1.6), glm::ivec3(1));
    for (std::size_t v = 0; v < shape.positions.size(); ++v)
        shape.textureCoordinates.push_back(options.repeats *
                                           glm::vec2((v & 1u) != 0 ? 1.0f : 0.0f, (v & 2u) != 0 ? 1.0f : 0.0f));
    return std::make_shared<const Shape>(std::move(shape));
}

Material leafMaterial(const CutoutSceneOptions& options) {
    Material material = matt("leaf", {0.3f, 0.6f, 0.2f});
    material.doubleSided = !options.closed;
    material.baseColor = {.image = 0, .wrapU = options.wrap, .wrapV = options.wrap};
    if (options.cutsOut)
        material.cutout =
            Cutout{.threshold = cutoutThreshold(static_cast<double>(options.cutoff), 1.0), .nearest = options.nearest};
    return material;
}

std::function<LightPose(double)> lightOf(const CutoutSceneOptions& options) {
    return [options](double seconds) {
        const double share = options.lightMoves ? backAndForth(seconds / duration) : 0.25;
        LightPose pose;
        pose.kind = options.sun ? LightKind::Directional : LightKind::Spot;
        pose.position = glm::dvec3(-2.0 + 1.2 * share, 7.0, 1.5);
        const glm::dvec3 towards = turnAbout({0.0, 0.0, 1.0}, 0.15 * share) * glm::normalize(glm::dvec3(0.3, 1.0, 0.2));
        pose.axes = options.sun ? lookAt(towards, glm::dvec3(0.0), {0.0, 0.0, 1.0}, 1.0, 1.0).axes
                                : lookAt({-2.0, 7.0, 1.5}, {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 1.0, 1.0).axes;
        pose.intensity = glm::dvec3(options.sun ? 1.0 : 60.0);
        pose.innerConeAngle = 0.5;
        pose.outerConeAngle = 0.6;
        return pose;
    };
}

MeshInstance placed(std::shared_ptr<const Shape> shape, bool moves, const std::function<RigidPose(double)>& pose) {
    MeshInstance instance;
    instance.shape = std::move(shape);
    instance.material = 1;
    const auto poseAt = [pose](double seconds) { return pose(backAndForth(seconds / duration)); };
    instance.pose = poseAt(0.0);
    if (moves) instance.motion = poseAt;
    return instance;
}

}  // namespace

Image leafImage(int side) {
    Image image{"leaf", side, side, {}};
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double x = (2.0 * column + 1.0) / side - 1.0, y = (2.0 * row + 1.0) / side - 1.0;
            const double leaf = 0.8 - 0.25 * std::cos(7.0 * std::atan2(y, x)) - std::hypot(x, 0.8 * y);
            const double inside = std::min(leaf, std::hypot(x - 0.2, y + 0.1) - 0.18);
            const auto alpha = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(0.5 + 4.0 * inside, 0.0, 1.0)));
            image.rgba.insert(image.rgba.end(), {200, 220, 120, alpha});
        }
    return image;
}

std::unique_ptr<Scene> makeCutoutScene(const CutoutSceneOptions& options) {
    SceneParts parts;
    parts.name = "cutouts";
    parts.defaults = {0.0, 1.0, 1.0};
    parts.duration = duration;
    parts.materials = {matt("ground", {0.5f, 0.5f, 0.5f}), leafMaterial(options)};
    parts.images.push_back(leafImage(24));
    parts.instances.push_back(ground(9.0, 0));
    const double tilt = options.tilted ? 1.1 : 0.1;
    parts.instances.push_back(
        placed(options.closed ? sides(options) : card(2.4, 2.0, options), options.cardsMove, [tilt](double share) {
            return RigidPose{{-0.5 + 0.7 * share, 2.4, 0.3 - 0.2 * share}, turnAbout({0.0, 0.6, 0.8}, tilt)};
        }));
    parts.instances.push_back(placed(card(3.0, 2.6, options), options.cardsMove, [](double share) {
        return RigidPose{{0.6, 1.0, -0.2}, turnAbout({1.0, 0.0, 0.0}, 0.2 + 0.15 * share)};
    }));
    const bool cameraMoves = options.cameraMoves;
    parts.cameras.emplace_back("only", [cameraMoves](double seconds) {
        const double share = cameraMoves ? backAndForth(seconds / duration) : 0.0;
        return lookAt({1.0 + 0.4 * share, 5.5, 6.5}, {0.2, 0.6, 0.1 * share}, {0.0, 1.0, 0.0}, 0.75, 0.05);
    });
    parts.light = lightOf(options);
    parts.bounds.add(glm::dvec3(-4.5, -1.0, -4.5));
    parts.bounds.add(glm::dvec3(4.5, 4.5, 4.5));
    return std::make_unique<MeshScene>(std::move(parts));
}

CameraPose belowTheCards() { return lookAt({0.9, 0.5, -0.6}, {0.9, 0.0, -0.6}, {0.0, 0.0, -1.0}, 1.8, 0.02); }

}  // namespace timeshade
