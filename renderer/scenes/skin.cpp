#include "scenes/skin.h"

#include <algorithm>
#include <utility>

#include "core/check.h"
#include "core/parallel.h"

namespace timeshade {

Skin::Skin(std::shared_ptr<const Shape> shape, std::vector<Influences> influences, Bones bones)
    : shape_(std::move(shape)), influences_(std::move(influences)), bones_(std::move(bones)) {
    CHECK_EQ(influences_.size(), shape_->positions.size());
}

void Skin::bend(double seconds, const std::vector<std::uint32_t>& vertices, glm::dvec3* positions,
                glm::vec3* normals) const {
    const std::vector<RigidPose> bones = bones_(seconds);
    forEachOf(vertices.size(), 8192, [&](std::size_t i) {
        const std::uint32_t vertex = vertices[i];
        const Influences& follows = influences_[vertex];
        glm::dmat3 axes(0.0);
        glm::dvec3 position(0.0);
        for (std::size_t k = 0; k < follows.bones.size(); ++k) {
            if (follows.shares[k] == 0.0) continue;
            axes += follows.shares[k] * bones[follows.bones[k]].axes;
            position += follows.shares[k] * bones[follows.bones[k]].position;
        }
        positions[i] = axes * shape_->positions[vertex] + position;
        if (normals != nullptr) normals[i] = glm::normalize(glm::mat3(axes) * shape_->normals[vertex]);
    });
}

double Skin::turn(double fromSeconds, double toSeconds) const {
    const std::vector<RigidPose> from = bones_(fromSeconds), to = bones_(toSeconds);
    double most = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) most = std::max(most, degreesBetween(from[i], to[i]));
    return most;
}

}  // namespace timeshade
