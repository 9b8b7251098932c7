#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "scene/camera.h"
#include "scene/motion_mesh.h"

namespace timeshade {

/// The nearest point of the mesh, halfway between its two ends, that the pose sees at a place of the picture: shares of
/// its width and height from the upper left. Nothing where it sees nothing. For a click, not for pictures: what alpha
/// cuts out counts as a surface.
std::optional<glm::dvec3> seenPoint(const MotionMesh& mesh, const CameraPose& pose, double aspectRatio, double x,
                                    double y);

}  // namespace timeshade
