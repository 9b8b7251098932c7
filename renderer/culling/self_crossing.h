#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace timeshade {

/// Whether an edge of one triangle intersects another triangle that shares no edge with it, to double precision.
/// Triangles are indices of positions. Coplanar triangles do not count. Also true if the search is given up: after a
/// hundred million pairs of triangles whose boxes cannot be separated by splitting space, as in a fan of 100,000.
bool mayCrossItself(const std::vector<glm::dvec3>& positions, const std::vector<glm::u32vec3>& triangles);

}  // namespace timeshade
