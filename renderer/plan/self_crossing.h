#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace timeshade {

/// Does an edge of one triangle meet another triangle that has no edge in common with it? Triangles name their corners by number; corners with one
/// number are the same. Two that lie in one plane do not cross. As double precision sees it.
bool crossesItself(const std::vector<glm::dvec3>& positions, const std::vector<glm::u32vec3>& triangles);

} // namespace timeshade
