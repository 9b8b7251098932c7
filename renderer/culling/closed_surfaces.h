#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "plan/view_plan.h"
#include "scene/material.h"
#include "scene/motion_mesh.h"

namespace timeshade {

/// Surfaces without a border: triangles connected by their edges, each edge run through as often one way as the other.
/// The winding number around such a surface drops by one where a way crosses it outwards, through a triangle from its
/// back to its front, and rises by one where it goes inwards. It is 0 at a light outside; where it is not negative at
/// the receiver, the way to the light goes out at least as often as in. So whoever asks only whether that way meets the
/// surface may leave out all crossings inwards: triangles that face away from the light. (Second-depth shadow maps rest
/// on the same: Wang, Molnar 1994.) Inwards, because those may lie too near to the receiver to count, while the
/// crossing outwards that goes with them counts.
///
/// Where is it not negative? Everywhere, if the surface meets itself nowhere and encloses a positive volume. That is
/// found out at rest and holds for whatever moves by one matrix that does not mirror. Of a surface that deforms it is
/// taken that no part of it is turned inside out before the camera's eyes; where one is, a receiver seen through its
/// backs may be called lit. And it is 0 where a camera ray from outside has met nothing, if the camera sees both sides
/// of all the surface's triangles, whatever its shape.
class ClosedSurfaces {
  public:
    /// `mesh`: at rest, at u = 0. Vertices of one instance that lie on one another there are taken for one.
    ClosedSurfaces(const MotionMesh& mesh, const std::vector<Material>& materials);

    std::size_t count() const { return surfaces_.size(); }
    /// One entry a triangle: 1 .. count(), or 0 where it belongs to none.
    const std::vector<std::uint32_t>& ofTriangles() const { return ofTriangles_; }

    /// One entry a surface, [0] false: may its crossings inwards be left out? All through the shutter, then, what was
    /// taken for one vertex is one to the last bit, a spot light and its near plane lie outside, and so do the camera
    /// and its own where the surface calls for it. `mesh` has the topology of the constructor's; the views' positions
    /// are relative to `origin`.
    std::vector<char> facingAwayCullable(const MotionMesh& mesh, const glm::dvec3& origin, const ViewPlan& camera,
                                         const ViewPlan& light) const;

  private:
    struct Surface {
        std::vector<std::uint32_t> vertices;
        bool nowhereNegative = false;            ///< the winding number, at rest; else all its triangles are two-sided
        std::array<std::uint32_t, 4> corners{};  ///< a tetrahedron of vertices, of positive volume at rest
    };
    struct Seam {
        std::uint32_t vertex, same, surface;  ///< the second stands for both
    };
    std::vector<std::uint32_t> ofTriangles_;
    std::vector<Surface> surfaces_;  ///< surface i at [i - 1]
    std::vector<Seam> seams_;
};

}  // namespace timeshade
