#pragma once

#include <cstdint>
#include <memory>

#include <glm/glm.hpp>

#include "plan/frame_plan.h"

namespace timeshade::oracle {

/// Where the triangles of a plan cover, whose alpha may cut parts of them out (docs/numerics.md, "Cut-outs"): in double
/// precision, with arithmetic of its own.
class CutoutCover {
  public:
    explicit CutoutCover(const FramePlan& plan) : cutouts_(plan.cutouts), mesh_(plan.mesh) {}

    bool isCutOut(std::uint32_t triangle) const {
        return cutouts_ && cutouts_->sheet(mesh_->topology->triangleMaterials[triangle]).cuts;
    }

    struct Cover {
        bool covers = true;
        bool doubtful = false;  ///< another point, as near as was said, is not as this one
    };
    /// At the barycentrics (1 - y - z, y, z), of which y and z may each be off by `slack`.
    Cover at(std::uint32_t triangle, const glm::dvec2& barycentrics, double slack) const;
    /// At the point from + s (to - from) of the triangle's plane; a float's rounding may move it by marginalShare of
    /// the distances.
    Cover onLine(std::uint32_t triangle, const glm::dvec3 (&vertices)[3], const glm::dvec3& from, const glm::dvec3& to,
                 double s) const;

  private:
    std::shared_ptr<const Cutouts> cutouts_;
    std::shared_ptr<const MotionMesh> mesh_;
};

}  // namespace timeshade::oracle
