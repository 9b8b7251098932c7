#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "scenes/flesh.h"
#include "scenes/rigid_pose.h"
#include "scenes/shape.h"

namespace timeshade {

/// The bones that a vertex follows, and by which shares; those sum to 1.
struct Influences {
    std::array<std::uint32_t, 4> bones{};
    std::array<double, 4> shares{};
};

/// A shape whose vertices follow bones: linear blend skinning, as of glTF.
class Skin final : public Flesh {
  public:
    using Bones = std::function<std::vector<RigidPose>(double seconds)>;

    /// One entry of `influences` per vertex of the shape, which is as the bones are at rest.
    Skin(std::shared_ptr<const Shape> shape, std::vector<Influences> influences, Bones bones);

    void bend(double seconds, const std::vector<std::uint32_t>& vertices, glm::dvec3* positions,
              glm::vec3* normals) const override;
    double turn(double fromSeconds, double toSeconds) const override;

  private:
    std::shared_ptr<const Shape> shape_;
    std::vector<Influences> influences_;
    Bones bones_;
};

}  // namespace timeshade
