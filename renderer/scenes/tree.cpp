#include "scenes/tree.h"

#include <cmath>

#include "scenes/branches.h"
#include "scenes/staging.h"

namespace timeshade {

namespace {

constexpr int frames = 48;
constexpr double framesPerSecond = 24.0;
constexpr double groundSide = 40.0;
constexpr std::uint32_t kindsOfSprays = 12;

void addSprays(SceneParts& parts, const std::vector<RigidPose>& roots, double most, std::uint32_t seed) {
    std::vector<std::shared_ptr<const Shape>> shapes;
    for (std::uint32_t kind = 0; kind < kindsOfSprays; ++kind)
        shapes.push_back(std::make_shared<const Shape>(sprayOfLeaves(seed * kindsOfSprays + kind)));
    for (std::size_t i = 0; i < roots.size(); ++i) {
        Dice dice(seed + 104729u, static_cast<std::uint32_t>(i));
        const RigidPose root = roots[i];
        // The wind comes from the left: neighbours sway one after the other.
        const double phase = dice.between(-0.12, 0.12) - 0.13 * root.position.x, size = most * dice.between(0.5, 1.0);
        const int times = dice.share() < 0.3 ? 3 : 2;
        const auto poseAt = [=](double seconds) {
            const double swing = std::sin(2.0 * pi * (times * seconds * framesPerSecond / frames + phase));
            return RigidPose{root.position, turnAbout({0.0, 0.0, 1.0}, size * swing) * root.axes};
        };
        MeshInstance instance;
        instance.shape = shapes[i % kindsOfSprays];
        instance.material = 2 + static_cast<std::uint32_t>(dice.below(3));
        instance.pose = root;
        if (most > 0.0) instance.motion = poseAt;
        parts.instances.push_back(std::move(instance));
    }
}

}  // namespace

const RecipeDescription& Tree::description() const {
    static const RecipeDescription description{"tree",
                                               "a tree with 12,600 leaves, 112,000 triangles, under a sun that moves"};
    return description;
}

void Tree::visitSettings(SettingsVisitor& visitor) {
    visitor.whole("sprays", sprays_, 900.0, 10.0, 2000.0, "sprays", "How many sprays of 14 leaves it bears.");
    visitor.number("sway", sway_, 1.5, 0.0, 15.0, "degrees", "How far the wind turns a spray to either side, at most.");
    visitor.number("sun", sun_, 4.0, 0.0, 6.0, "degrees per frame", "How far the sun moves in one frame.");
    visitor.whole("seed", seed_, 1, 1, 1000, "seed", "Another number is another tree.");
}

std::unique_ptr<Scene> Tree::make() {
    SceneParts parts;
    parts.name = description().name;
    parts.defaults = {5.0, framesPerSecond, 1.0};
    parts.duration = sway_ > 0.0f || sun_ > 0.0f ? frames / framesPerSecond : 0.0;
    parts.parameters = parametersOf(*this);
    parts.materials = {matt("meadow", {0.15f, 0.18f, 0.06f}, 0.95f), matt("bark", {0.30f, 0.21f, 0.14f}, 0.9f),
                       matt("leaf", {0.20f, 0.36f, 0.09f}, 0.55f), matt("light leaf", {0.32f, 0.44f, 0.12f}, 0.55f),
                       matt("young leaf", {0.48f, 0.50f, 0.15f}, 0.55f)};
    for (std::size_t leaf = 2; leaf < parts.materials.size(); ++leaf) parts.materials[leaf].doubleSided = true;
    parts.instances.push_back(ground(groundSide, 0));
    Branches branches = grownBranches(static_cast<std::uint32_t>(seed_), sprays_);
    MeshInstance wood;
    wood.shape = std::make_shared<const Shape>(std::move(branches.wood));
    wood.material = 1;
    parts.instances.push_back(std::move(wood));
    addSprays(parts, branches.sprays, glm::radians(static_cast<double>(sway_)), static_cast<std::uint32_t>(seed_));

    const double turn = glm::radians(static_cast<double>(sun_));
    parts.light = [turn](double seconds) {
        // There and back, within a quarter of its way to either side.
        const double angle = turn * 0.5 * frames * (backAndForth(seconds * framesPerSecond / frames) - 0.5);
        LightPose pose;
        pose.kind = LightKind::Directional;
        const glm::dvec3 towards = turnAbout({0.0, 1.0, 0.0}, angle) * glm::normalize(glm::dvec3(-0.62, 1.0, 0.30));
        pose.axes = lookAt(towards, glm::dvec3(0.0), glm::dvec3(0.0, 0.0, 1.0), 1.0, 1.0).axes;
        pose.intensity = {1.0, 0.96, 0.88};
        return pose;
    };
    parts.cameras.emplace_back("meadow", staticCamera({5.6, 4.4, 10.8}, {1.1, 2.55, 0.0}, 0.68));
    parts.cameras.emplace_back("shade", staticCamera({7.0, 4.6, 5.2}, {2.4, 0.3, -0.8}, 0.62));
    const double reach = treeReach + 0.9;
    parts.bounds.add(glm::dvec3(-0.5 * groundSide, -0.6, -0.5 * groundSide));
    parts.bounds.add(glm::dvec3(std::max(reach, 0.5 * groundSide), treeHeight + 0.9, 0.5 * groundSide));
    return std::make_unique<MeshScene>(std::move(parts));
}

}  // namespace timeshade
