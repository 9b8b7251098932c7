#include "support/crowded_scene.h"

#include <cmath>
#include <utility>

#include "scenes/mesh_scene.h"
#include "scenes/staging.h"

namespace timeshade {

namespace {

enum MaterialOfCrowd : std::uint32_t { oneSided, twoSided };

constexpr double seconds = 8.0;

Shape insideOut(Shape shape) {
    for (glm::u32vec3& t : shape.triangles) std::swap(t.y, t.z);
    return shape;
}

Shape anyShape(Dice& dice) {
    Shape shape;
    switch (dice.below(4)) {
    case 0:
        shape = box({dice.between(0.3, 1.6), dice.between(0.3, 1.6), dice.between(0.3, 1.6)},
                    glm::ivec3(1 + static_cast<int>(dice.below(2))));
        break;
    case 1:
        shape = stretched(geodesicSphere(2), {dice.between(0.2, 0.8), dice.between(0.2, 0.8), dice.between(0.2, 0.8)});
        break;
    case 2:
        shape = turned(
            {{0.0, -0.7}, {0.6, -0.6}, {dice.between(0.1, 0.4), 0.0}, {0.5, 0.5}, {0.0, dice.between(0.3, 0.9)}}, 7);
        break;
    default:
        shape = geodesicSphere(2);
        shape.add(insideOut(stretched(geodesicSphere(2), glm::dvec3(0.7))));
        shape = stretched(std::move(shape), glm::dvec3(dice.between(0.3, 0.7)));
    }
    const std::uint32_t flaw = dice.below(6);
    if (flaw == 0) shape = insideOut(std::move(shape));
    if (flaw == 1) shape.triangles.pop_back();
    return shape;
}

std::function<RigidPose(double)> anyMotion(Dice& dice) {
    const glm::dvec3 middle(dice.between(-4.0, 4.0), dice.between(-0.3, 2.6), dice.between(-4.0, 4.0)),
        swing = dice.direction() * dice.between(0.0, 0.9);
    const glm::dvec3 axis = dice.direction();
    const double start = dice.between(0.0, 2.0 * pi), turn = dice.below(2) == 0 ? 2.0 * pi / seconds : 0.0;
    return [=](double time) {
        const double phase = 2.0 * pi * time / seconds;
        return RigidPose{middle + swing * std::sin(phase + start),
                         turnAbout(axis, start + turn * 0.3 * std::sin(phase) * seconds)};
    };
}

}  // namespace

std::unique_ptr<Scene> makeCrowdedScene(const CrowdedSceneOptions& options) {
    const glm::dvec3 eye(3.0, 8.0, 10.0);
    const glm::dvec3 lamp =
        options.aroundTheEye ? glm::dvec3(0.0, 9.0, 0.0) : glm::dvec3(-2.0, 9.0, 1.0);  // above all of the walls
    SceneParts parts;
    parts.name = "crowded";
    parts.duration = seconds;
    parts.defaults = {0.0, 1.0, 1.0};
    parts.materials = {matt("one-sided", glm::vec3(0.5f)), matt("two-sided", glm::vec3(0.7f))};
    parts.materials[twoSided].doubleSided = true;
    parts.instances.push_back(ground(16.0, oneSided));
    const auto add = [&](Shape shape, std::uint32_t material, const glm::dvec3& position) {
        MeshInstance instance;
        instance.shape = std::make_shared<const Shape>(std::move(shape));
        instance.material = material;
        instance.pose.position = position;
        parts.instances.push_back(std::move(instance));
    };
    for (std::uint32_t i = 0; i < 24; ++i) {
        Dice dice(options.seed, i);
        MeshInstance instance;
        instance.shape = std::make_shared<const Shape>(anyShape(dice));
        instance.material = dice.below(3) == 0 ? twoSided : oneSided;
        instance.motion = anyMotion(dice);
        if (options.overTheGround)
            instance.motion = [motion = instance.motion](double time) {
                RigidPose pose = motion(time);
                pose.position.y += 3.0;
                return pose;
            };
        instance.pose = instance.motion(0.0);
        if (i % 4 == 0) instance.motion = nullptr;
        parts.instances.push_back(std::move(instance));
    }
    if (options.insideARoom) add(insideOut(box({15.0, 7.0, 15.0}, glm::ivec3(2))), oneSided, {0.0, 3.0, 0.0});
    if (options.aroundTheEye) add(insideOut(box({26.0, 9.1, 26.0}, glm::ivec3(2))), twoSided, {0.0, 4.05, 0.0});
    if (options.aroundTheLight) add(box({0.7, 0.5, 0.6}, glm::ivec3(1)), oneSided, lamp);
    parts.cameras.emplace_back("only", staticCamera(eye, {0.0, 0.8, 0.0}, 0.7));
    if (options.directionalLight) {
        parts.light = [lamp](double) {
            LightPose pose = staticSpot(lamp, glm::dvec3(0.0), 0.7, 0.8)(0.0);
            pose.kind = LightKind::Directional;
            return pose;
        };
    } else {
        parts.light = staticSpot(lamp, {0.0, 0.0, 0.0}, 0.7, 0.8);
    }
    parts.bounds.add(glm::dvec3(-8.0, -2.0, -8.0));
    parts.bounds.add(glm::dvec3(8.0, 10.0, 11.0));
    return std::make_unique<MeshScene>(std::move(parts));
}

}  // namespace timeshade
