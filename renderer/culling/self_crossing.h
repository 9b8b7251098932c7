#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace timeshade {

/// Does an edge of one triangle meet another triangle that has no edge in common with it? Triangles name their corners
/// by number; corners with one number are the same. Two that lie in one plane do not cross. As double precision sees
/// it. True as well where that would take too long to find out: after a hundred million pairs of triangles whose boxes
/// can't be told apart by halving space, as in a fan of 100,000.
bool mayCrossItself(const std::vector<glm::dvec3>& positions, const std::vector<glm::u32vec3>& triangles);

}  // namespace timeshade
