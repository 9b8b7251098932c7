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

/// How the camera or the light's map sees the scene during a shutter, and which triangles it has to draw.
struct ViewPlan {
    Projection projection = Projection::Perspective;
    bool turns = false;  ///< the view's axes differ between the ends; never for a light
    ViewEnd open, close;
    shared::ViewBlock block{};

    /// Triangles that may be seen, in ascending order, each in one of the two lists. Small ones are drawn as points:
    /// none is ever wider than maximumPointSide pixels.
    std::vector<std::uint32_t> smallTriangles;
    std::vector<std::uint32_t> largeTriangles;
    std::size_t outsideTriangles = 0;     ///< dropped: never inside the view
    std::size_t facingAwayTriangles = 0;  ///< dropped: one-sided and turned away all through the shutter
};

/// Sides that GL promises nowhere but every driver has; the sample pass falls back on rectangles above it.
inline constexpr int maximumPointSide = 63;

/// Fills the block's matrices from the ends of the view. near and far in world units.
void finishView(ViewPlan& view, glm::dvec2 size, double nearDistance, double farDistance);

struct CullingRules {
    bool dropFacingAway = false;       ///< true for the camera, which sees no backs of one-sided triangles
    std::uint32_t strata = 1;
    double timeBase = 0.0, timeScale = 1.0;
};

/// Fills the view's lists. `positionTexels` are the mesh's uploaded texels (TRIANGLE_POSITION_TEXELS a triangle), so
/// that what is decided here is decided on the very numbers that the GPU sees.
void listTriangles(ViewPlan& view, const std::vector<glm::vec4>& positionTexels, const CullingRules& rules);

} // namespace timeshade
