#include "scene/grounded_scene.h"

#include <utility>

#include <fmt/format.h>

#include "scene/fitted_views.h"
#include "scene/ground_fit.h"

namespace timeshade {

namespace {

Material groundMaterial() {
    Material material;
    material.name = "ground";
    material.baseColorFactor = glm::vec4(0.34f, 0.33f, 0.31f, 1.0f);
    material.metallicFactor = 0.0f;
    material.roughnessFactor = 0.9f;
    return material;
}

}  // namespace

GroundedScene::GroundedScene(std::shared_ptr<const Scene> scene, const GroundSettings& settings)
    : scene_(std::move(scene)), notes_(scene_->notes()) {
    lay(settings);
}

GroundedScene::GroundedScene(const GroundedScene& other, const GroundSettings& settings)
    : scene_(other.scene_), fit_(other.fit_), notes_(scene_->notes()) {
    lay(settings);
}

void GroundedScene::lay(const GroundSettings& settings) {
    if (settings.choice == GroundChoice::Off) return;
    if (settings.choice == GroundChoice::Auto && !fit_.lacksGround) fit_.lacksGround = lacksGround(*scene_);
    if (settings.choice == GroundChoice::Auto && !*fit_.lacksGround) return;
    if (!fit_.square) fit_.square = fittedGround(*scene_);
    square_ = fit_.square;
    square_->centre.y = settings.height.value_or(square_->centre.y);
    square_->side = settings.size.value_or(square_->side);
    materials_ = scene_->materials();
    materials_.push_back(groundMaterial());
    if (scene_->cameras().size() == 1 && scene_->camera(0, 0.0).eye == fittedCamera(scene_->bounds()).eye)
        fittedCamera_ = fittedCamera(boundsWithShadow(*scene_));
    if (settings.choice == GroundChoice::Auto)
        notes_.push_back(fmt::format(
            "the file has no surface below its things; a ground is added at the height {:.4g}, {:.4g} wide (--ground)",
            square_->centre.y, square_->side));
}

std::string GroundedScene::contentDigest() const {
    if (!square_) return scene_->contentDigest();
    const glm::dvec3& c = square_->centre;
    return fmt::format("{} ground {} {} {} {}", scene_->contentDigest(), c.x, c.y, c.z, square_->side);
}

std::shared_ptr<const MeshTopology> GroundedScene::topologyWithSquare(
    const std::shared_ptr<const MeshTopology>& bare) const {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<const MeshTopology>& known = topologies_[bare];
    if (known) return known;
    auto topology = std::make_shared<MeshTopology>(*bare);
    const auto first = static_cast<std::uint32_t>(topology->vertexCount);
    topology->vertexCount += 4;
    topology->textureCoordinates.resize(topology->vertexCount, glm::vec2(0.0f));
    if (!topology->moreCoordinates.empty()) topology->moreCoordinates.resize(topology->vertexCount, glm::vec4(0.0f));
    if (!topology->colours.empty()) topology->colours.resize(topology->vertexCount, glm::vec4(1.0f));
    for (const glm::u32vec3& corners : {glm::u32vec3(0, 1, 2), glm::u32vec3(0, 2, 3)}) {
        topology->triangles.push_back(corners + first);
        topology->triangleMaterials.push_back(static_cast<std::uint32_t>(materials_.size() - 1));
        topology->triangleInstances.push_back(static_cast<std::uint32_t>(topology->instanceCount));
    }
    ++topology->instanceCount;
    return known = topology;
}

MotionMesh GroundedScene::motionMesh(double openSeconds, double closeSeconds) const {
    MotionMesh mesh = scene_->motionMesh(openSeconds, closeSeconds);
    if (!square_) return mesh;
    mesh.topology = topologyWithSquare(mesh.topology);
    const double half = 0.5 * square_->side;
    for (const glm::dvec2& corner : {glm::dvec2(-half, half), {half, half}, {half, -half}, {-half, -half}}) {
        const glm::dvec3 position = square_->centre + glm::dvec3(corner.x, 0.0, corner.y);
        mesh.positionsOpen.push_back(position);
        mesh.positionsClose.push_back(position);
        mesh.normalsOpen.emplace_back(0.0f, 1.0f, 0.0f);
        mesh.normalsClose.emplace_back(0.0f, 1.0f, 0.0f);
    }
    return mesh;
}

}  // namespace timeshade
