#pragma once

#include <cstdint>
#include <memory>

#include "scene/scene.h"

namespace timeshade {

/// Options of a crowded scene.
struct CrowdedSceneOptions {
    std::uint32_t seed = 1;
    bool directionalLight = false;
    bool insideARoom =
        false;  ///< one-sided walls face inwards: the camera, outside, looks in through their backs, the light can't
    bool aroundTheEye = false;    ///< two-sided walls inside out about the camera and all else but the light
    bool aroundTheLight = false;  ///< a box about a spot light
    bool overTheGround = false;   ///< nothing sinks into it
};

/// Boxes, balls and lathed shapes that move and rotate over a ground, sink into it and into one another: one-sided and
/// two-sided, whole, with a triangle missing, inside out, hollow. One second is one frame; motion repeats after eight.
std::unique_ptr<Scene> makeCrowdedScene(const CrowdedSceneOptions& options);

}  // namespace timeshade
