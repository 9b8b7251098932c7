#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scene/camera.h"
#include "shared/frame_blocks.shared.h"

namespace timeshade {

struct MotionMesh;

enum class Projection { Perspective, Orthographic };

/// One end of the shutter of a view. The ray through the image position (s, t), both in [0, 1] with t upwards, is
/// eye + distance * (corner + s * right + t * up); the three vectors are those of an image plane at distance 1.
struct ViewEnd {
    glm::dvec3 eye;     ///< relative to FramePlan::origin
    glm::dvec3 corner;  ///< from the eye to the image plane's lower left corner
    glm::dvec3 right;   ///< along the image's full width
    glm::dvec3 up;      ///< along the image's full height
    /// Orthographic: the way that light travels, its component across the map's plane being 1. The plane is the same at
    /// both ends; where a sun turns, what is projected on it slants.
    glm::dvec3 direction{0.0};
};

/// Triangle ids in ascending order. Small ones are drawn as points: none is wider than maximumPointSide pixels at any
/// time.
struct TriangleLists {
    std::vector<std::uint32_t> small, large;
    std::size_t count() const { return small.size() + large.size(); }
    bool empty() const { return count() == 0; }
};

/// A view of the scene during a shutter, the camera's or the shadow map's, and the triangles to draw in it.
struct ViewPlan {
    Projection projection = Projection::Perspective;
    bool turns = false;  ///< the view's image plane differs between the ends; never for a light
    ViewEnd open, close;
    shared::ViewBlock block{};

    /// Triangles that may be visible, by whether they move relative to the view. Each is in one list.
    TriangleLists staticTriangles, dynamicTriangles;
    std::size_t outsideTriangles = 0;     ///< dropped: never inside the view
    std::size_t facingAwayTriangles = 0;  ///< dropped: one-sided and facing away during the whole shutter
    std::size_t unseenTriangles = 0;      ///< dropped: dynamic casters whose shadow the camera cannot see
};

/// Largest point size, in pixels. GL guarantees only 1, but all known drivers support this; larger triangles are drawn
/// as rectangles.
inline constexpr int maximumPointSide = 63;

/// A camera as one end of a view; eye relative to the origin. aspect: the image's width over its height.
ViewEnd viewEndOf(const CameraPose& pose, const glm::dvec3& origin, double aspect);

/// Fills the view's block from its ends. size: pixels; near and far distance: world units; far is used by orthographic
/// views only.
void finishView(ViewPlan& view, glm::dvec2 size, double nearDistance, double farDistance);

}  // namespace timeshade
