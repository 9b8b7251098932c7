#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

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
};

/// Triangles in ascending order. Small ones are drawn as points: none is ever wider than maximumPointSide pixels.
struct TriangleLists {
    std::vector<std::uint32_t> small, large;
    std::size_t count() const { return small.size() + large.size(); }
    bool empty() const { return count() == 0; }
};

/// How the camera or the light's map sees the scene during a shutter, and which triangles it has to draw.
struct ViewPlan {
    Projection projection = Projection::Perspective;
    bool turns = false;  ///< the view's axes differ between the ends; never for a light
    ViewEnd open, close;
    shared::ViewBlock block{};

    /// Triangles that may be seen, each in one list: apart by whether they move relative to the view.
    TriangleLists staticTriangles, dynamicTriangles;
    std::size_t outsideTriangles = 0;     ///< dropped: never inside the view
    std::size_t facingAwayTriangles = 0;  ///< dropped: one-sided and turned away all through the shutter
    std::size_t unseenTriangles = 0;      ///< dropped: moving casters whose shadow nobody sees
};

/// Sides that GL promises nowhere but every driver has; the sample pass falls back on rectangles above it.
inline constexpr int maximumPointSide = 63;

/// Fills the block's matrices from the ends of the view. near and far in world units.
void finishView(ViewPlan& view, glm::dvec2 size, double nearDistance, double farDistance);

}  // namespace timeshade
