#include "cases/set_up_c.h"

#include <cmath>

namespace timeshade {

namespace {

constexpr double outerCone = 0.62;  // radians; contains every receiver of the catalogue
constexpr int columnWidth = 1, columnHeight = 192, pointSide = 8;

void move(glm::dvec3 (&corners)[4], const glm::dvec3& by) {
    for (glm::dvec3& corner : corners) corner += by;
}
void move(glm::dvec3 (&corners)[3], const glm::dvec3& by) {
    for (glm::dvec3& corner : corners) corner += by;
}

}  // namespace

SetUpC::SetUpC() = default;

SetUpC& SetUpC::quad(const MovingQuad& caster) {
    scene_.quads.push_back(caster);
    return *this;
}

SetUpC& SetUpC::triangle(const MovingCorners& caster) {
    scene_.triangles.push_back(caster);
    return *this;
}

SetUpC& SetUpC::slidingQuad(double c0, double c1, double z, double halfX) {
    return quad(timeshade::slidingQuad({c0, 0.0, z}, {c1, 0.0, z}, halfX, -0.4, 0.6));
}

SetUpC& SetUpC::risingQuad(double z0, double z1) {
    return quad(timeshade::slidingQuad({0.0, 0.0, z0}, {0.0, 0.0, z1}, 0.5, -0.4, 0.6));
}

SetUpC& SetUpC::light(const glm::dvec3& open, const glm::dvec3& close) {
    lightOpen_ = open;
    lightClose_ = close;
    return *this;
}

SetUpC& SetUpC::receiver(const glm::dvec3& open, const glm::dvec3& close) {
    receiverOpen_ = open;
    receiverClose_ = close;
    return *this;
}

SetUpC& SetUpC::cameraHeight(double height) {
    height_ = height;
    return *this;
}

SetUpC& SetUpC::point(double size) {
    isPoint_ = true;
    patchHeight_ = size;
    return *this;
}

SetUpC& SetUpC::column(double height) {
    patchHeight_ = height;
    return *this;
}

SetUpC& SetUpC::receiverIsCaster() {
    receiverIsCaster_ = true;
    return *this;
}

SetUpC& SetUpC::narrowReceiver(double halfX, double cameraTravel) {
    receiverHalfX_ = halfX;
    cameraTravel_ = cameraTravel;
    return *this;
}

SetUpC& SetUpC::offset(const glm::dvec3& by) {
    offset_ = by;
    return *this;
}

LightPose SetUpC::lightAt(const glm::dvec3& position) const {
    LightPose light;
    light.position = position + offset_;  // with identity axes it points along -z
    light.outerConeAngle = outerCone;
    light.innerConeAngle = 0.9 * outerCone;
    light.intensity = glm::dvec3(100.0);
    return light;
}

/// Looks straight down.
CameraPose SetUpC::cameraOver(const glm::dvec3& point) const {
    CameraPose camera;
    camera.eye = point + offset_ + glm::dvec3(0.0, 0.0, height_);
    camera.verticalFieldOfView = 2.0 * std::atan(0.5 * patchHeight_ / height_);
    camera.nearDistance = 0.01 * height_;
    return camera;
}

void SetUpC::finish(ClosedFormCase& c) {
    if (!receiverIsCaster_) quad(timeshade::slidingQuad(receiverOpen_, receiverClose_, receiverHalfX_, -0.8, 0.8));
    for (MovingQuad& q : scene_.quads) {
        move(q.open, offset_);
        move(q.close, offset_);
    }
    for (MovingCorners& t : scene_.triangles) {
        move(t.open, offset_);
        move(t.close, offset_);
    }
    // Quads come before triangles in the mesh; the receiver is the last quad.
    c.firstReceiver = 2 * (static_cast<std::uint32_t>(scene_.quads.size()) - 1);
    const glm::dvec3 travel(0.5 * cameraTravel_, 0.0, 0.0);
    c.receiverOpen = receiverOpen_ - travel + offset_;
    c.receiverClose = receiverClose_ + travel + offset_;
    if (cameraTravel_ > 0.0) {
        c.seenFrom = 0.5 - receiverHalfX_ / cameraTravel_;
        c.seenTo = 0.5 + receiverHalfX_ / cameraTravel_;
    }
    c.width = isPoint_ ? pointSide : columnWidth;
    c.height = isPoint_ ? pointSide : columnHeight;
    c.patchHeight = patchHeight_;
    c.patchWidth = patchHeight_ * c.width / c.height;
    scene_.cameraOpen = cameraOver(receiverOpen_ - travel);
    scene_.cameraClose = cameraOver(receiverClose_ + travel);
    scene_.lightOpen = lightAt(lightOpen_);
    scene_.lightClose = lightAt(lightClose_);
    scene_.overview =
        lookAt(offset_ + glm::dvec3(5.0, -9.0, 6.5), offset_ + glm::dvec3(0.0, 0.0, 2.5), {0.0, 0.0, 1.0}, 0.8, 0.05);
    scene_.finish("case:" + c.name);
    c.scene = std::make_shared<ProceduralScene>(std::move(scene_));
}

}  // namespace timeshade
