#pragma once

#include <memory>
#include <random>

#include "cases/procedural_scene.h"

namespace timeshade {

/// Options of a random scene for parity tests.
struct MovingSceneOptions {
    int quads = 60;
    unsigned seed = 1;
    bool cameraTurns = false;
    bool directionalLight = false;
    bool aroundTheEye = false;  ///< large quads about the camera: most reach behind it, some pass through it
};

/// One-sided quadrilaterals (not flat, so that their halves differ) that move and turn at random in front of a camera.
std::unique_ptr<ProceduralScene> makeMovingScene(const MovingSceneOptions& options);

}  // namespace timeshade
