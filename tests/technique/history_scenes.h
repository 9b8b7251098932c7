#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "cases/procedural_scene.h"
#include "measure/reference_technique.h"
#include "shared/hash.shared.h"
#include "support/gl_environment.h"
#include "techniques/history/history_shadow.h"

namespace timeshade {

/// A slanted board over a large floor; the light shines down from one side, the camera sees the shadow at an angle.
/// `boardStep` and `cameraStep`: how far they move in a second, which is a frame.
inline std::shared_ptr<ProceduralScene> boardScene(glm::dvec3 boardStep = glm::dvec3(0.0),
                                                   glm::dvec3 cameraStep = glm::dvec3(0.0)) {
    auto scene = std::make_shared<ProceduralScene>();
    scene->quads.push_back(slidingQuad({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 6.0, -6.0, 6.0));
    MovingQuad board{};
    const glm::dvec3 corners[4] = {{-0.9, -0.35, 2.0}, {0.7, -0.6, 2.2}, {0.9, 0.3, 2.4}, {-0.6, 0.65, 2.1}};
    for (int i = 0; i < 4; ++i) {
        board.open[i] = corners[i];
        board.close[i] = corners[i] + boardStep;
    }
    scene->quads.push_back(board);
    scene->lightOpen.position = scene->lightClose.position = {1.0, 0.5, 10.0};
    scene->lightOpen.outerConeAngle = scene->lightClose.outerConeAngle = 0.5;
    scene->lightOpen.innerConeAngle = scene->lightClose.innerConeAngle = 0.4;
    scene->lightOpen.intensity = scene->lightClose.intensity = glm::dvec3(100.0);
    CameraPose camera;
    camera.eye = {0.0, -1.2, 1.6};
    const glm::dvec3 back = glm::normalize(camera.eye - glm::dvec3(-0.2, 0.0, 0.0));
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 0.0, 1.0), back));
    camera.axes = glm::dmat3(right, glm::cross(back, right), back);
    camera.verticalFieldOfView = 1.2;
    camera.nearDistance = 0.01;
    scene->cameraOpen = scene->cameraClose = camera;
    scene->cameraClose.eye += cameraStep;
    scene->finish();
    return scene;
}

inline FrameRequest staticRequest(int width, int height, int mapSize) {
    FrameRequest request = ProceduralScene::request(width, height, 1, mapSize, 1);
    request.shutter.length = 0.0;
    return request;
}

inline std::unique_ptr<HistoryShadow> makeHistory() {
    return std::make_unique<HistoryShadow>(sharedRenderer().programs());
}

/// Lit values of one jittered map, without a history.
inline std::unique_ptr<HistoryShadow> makeJitteredMap() {
    auto technique = makeHistory();
    setFromText(*technique, "try_triangles", "off");
    return technique;
}

inline std::vector<float> drawnLit(const FramePlan& plan, Technique& technique) {
    sharedRenderer().draw(plan, technique, View::Visibility);
    return sharedRenderer().readVisibility();
}

inline std::vector<float> truthOf(const FramePlan& plan) {
    ReferenceTechnique truth;
    return drawnLit(plan, truth);
}

inline double meanDifference(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
    return sum / static_cast<double>(a.size());
}

/// Numbers that are random enough and the same everywhere.
class Lots {
  public:
    double next() { return static_cast<double>(shared::unitInterval(shared::hashWords({++count_, 17u, 4u}).x)); }

  private:
    std::uint32_t count_ = 0;
};

}  // namespace timeshade
