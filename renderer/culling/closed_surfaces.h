#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "plan/view_plan.h"
#include "scene/material.h"
#include "scene/motion_mesh.h"

namespace timeshade {

/// Closed surfaces: triangles connected by their edges, where each edge is used in one direction as often as in the
/// other, and none cut out by its alpha. Along the segment from a receiver to the light, the winding number of such a
/// surface decreases by one where the segment leaves it (through a triangle from back to front) and increases by one
/// where it enters. The winding number is 0 at a light outside. If it is not negative at the receiver, the segment
/// leaves at least as often as it enters, so a test for any intersection may ignore all entries: the triangles that
/// face away from the light. (Second-depth shadow maps use the same: Wang and Molnar 1994.) Entries and not exits are
/// ignored, because an entry may be too near to the receiver to count while the exit that belongs to it counts.
///
/// The winding number is nowhere negative if the surface does not intersect itself and encloses a positive volume. This
/// is tested on the mesh at rest and remains true under any rigid or affine motion that does not mirror. For a surface
/// that deforms it is assumed that no visible part is turned inside out; if one is, a receiver that is seen through its
/// back faces may be called lit. For surfaces of any shape the winding number is 0 at a receiver that a camera outside
/// sees directly, if all the surface's triangles are double-sided.
class ClosedSurfaces {
  public:
    /// `mesh`: at rest; positions at u = 0 are used. Vertices of one instance with equal positions are merged.
    ClosedSurfaces(const MotionMesh& mesh, const std::vector<Material>& materials);

    std::size_t count() const { return surfaces_.size(); }
    /// The surface of each triangle: 1 .. count(), or 0 if it belongs to none.
    const std::vector<std::uint32_t>& ofTriangles() const { return ofTriangles_; }

    /// For each surface (index 0 unused, false): whether its triangles that face away from the light may be culled.
    /// True only if, during the whole shutter, merged vertices stay bitwise equal, a spot light and its near plane are
    /// outside, and, for surfaces that need it, so are the camera and its near plane. `mesh` must have the topology of
    /// the constructor's mesh; the views' positions are relative to `origin`.
    std::vector<char> facingAwayCullable(const MotionMesh& mesh, const glm::dvec3& origin, const ViewPlan& camera,
                                         const ViewPlan& light) const;

  private:
    struct Surface {
        std::vector<std::uint32_t> vertices;
        bool nowhereNegative = false;  ///< the winding number at rest; if not, all its triangles are double-sided
        std::array<std::uint32_t, 4> corners{};  ///< a tetrahedron of vertices with positive volume at rest
    };
    struct Seam {
        std::uint32_t vertex, same, surface;  ///< `vertex` was merged into `same`
    };
    std::vector<std::uint32_t> ofTriangles_;
    std::vector<Surface> surfaces_;  ///< surface i at [i - 1]
    std::vector<Seam> seams_;
};

}  // namespace timeshade
