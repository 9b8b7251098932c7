#include "support/moving_scene.h"

#include <utility>

namespace timeshade {

std::unique_ptr<ProceduralScene> makeMovingScene(const MovingSceneOptions& options) {
    std::mt19937 random(options.seed);
    const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const auto vector = [&](double size) {
        return glm::dvec3(number(-size, size), number(-size, size), number(-size, size));
    };

    auto scene = std::make_unique<ProceduralScene>();
    const glm::dvec3 corners[4] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    for (int i = 0; i < options.quads; ++i) {
        const double size = options.aroundTheEye ? number(0.5, 3.0) : number(0.05, 1.0);
        const glm::dvec3 centre =
            options.aroundTheEye ? glm::dvec3(number(-2, 2), number(-2, 2), number(4, 7)) : vector(3.0);
        const glm::dvec3 move = i % 3 == 0 ? glm::dvec3(0.0) : vector(1.5);
        MovingQuad quad{};
        for (int c = 0; c < 4; ++c) {
            quad.open[c] = centre + size * corners[c] + vector(0.5 * size);
            quad.close[c] = quad.open[c] + move + (i % 2 == 0 ? glm::dvec3(0.0) : vector(0.4 * size));
        }
        // Some turn their back to the camera during the shutter.
        if (i % 5 == 0) std::swap(quad.close[0], quad.close[1]), std::swap(quad.close[2], quad.close[3]);
        scene->quads.push_back(quad);
    }
    scene->cameraOpen = lookAt({0.3, 0.4, 6.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.9, 0.02);
    scene->cameraClose = scene->cameraOpen;
    if (options.cameraTurns) scene->cameraClose = lookAt({0.8, 0.1, 5.5}, {0.5, -0.4, 0.0}, {0.1, 1.0, 0.0}, 0.9, 0.02);
    scene->lightOpen.position = {2.0, 7.0, 3.0};
    scene->lightOpen.axes = lookAt(scene->lightOpen.position, {0, 0, 0}, {0, 1, 0}, 1.0, 0.1).axes;
    scene->lightOpen.kind = options.directionalLight ? LightKind::Directional : LightKind::Spot;
    scene->lightOpen.innerConeAngle = 0.6;
    scene->lightOpen.outerConeAngle = 0.7;
    scene->lightClose = scene->lightOpen;
    scene->lightClose.position += glm::dvec3(0.5, -0.5, 0.25);
    scene->finish();
    return scene;
}

}  // namespace timeshade
