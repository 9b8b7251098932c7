#pragma once

#include <memory>
#include <utility>

#include "scenes/staging.h"

namespace timeshade {

/// A cube above a ground that spins about a vertical axis, half a turn a second at the same speed throughout; a spot
/// light and a camera stand still. A frame is a second, so that a whole shutter sees half a turn. `centre`: of the cube
/// as seen from the axis; by default one of its edges is the axis.
inline std::unique_ptr<Scene> makeSpinningCube(const glm::dvec3& centre = {0.7, 0.0, 0.7}) {
    SceneParts parts;
    parts.name = "spinning cube";
    parts.duration = 2.0;
    parts.defaults = {0.0, 1.0, 1.0};
    parts.materials = {matt("ground", {0.5f, 0.5f, 0.5f}), matt("cube", {0.6f, 0.2f, 0.1f})};
    parts.instances.push_back(ground(9.0, 0));
    MeshInstance cube;
    cube.shape = std::make_shared<const Shape>(box(glm::dvec3(1.4), {1, 1, 1}));
    cube.material = 1;
    cube.motion = [centre](double seconds) {
        const glm::dmat3 axes = turnAbout({0.0, 1.0, 0.0}, pi * seconds);
        return RigidPose{glm::dvec3(0.0, 1.6, 0.0) + axes * centre, axes};
    };
    parts.instances.push_back(std::move(cube));
    parts.cameras.emplace_back("above", staticCamera({0.5, 6.0, 6.0}, {-0.3, 0.4, 0.0}, 0.62));
    parts.light = staticSpot({2.5, 7.0, 1.5}, {0.0, 0.5, 0.0}, 0.4, 0.5);
    parts.bounds.add(glm::dvec3(-4.5, 0.0, -4.5));
    parts.bounds.add(glm::dvec3(4.5, 3.2, 4.5));
    return std::make_unique<MeshScene>(std::move(parts));
}

}  // namespace timeshade
