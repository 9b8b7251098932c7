#include "scene/geometry.h"

namespace timeshade {

std::vector<glm::vec3> generatedNormals(const std::vector<glm::vec3>& positions,
                                        const std::vector<glm::u32vec3>& triangles) {
    std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0.0));
    for (const glm::u32vec3& triangle : triangles) {
        const glm::dvec3 a(positions[triangle.x]);
        const glm::dvec3 areaNormal =
            glm::cross(glm::dvec3(positions[triangle.y]) - a, glm::dvec3(positions[triangle.z]) - a);
        for (int corner = 0; corner < 3; ++corner) sums[triangle[corner]] += areaNormal;
    }
    std::vector<glm::vec3> normals;
    normals.reserve(positions.size());
    for (const glm::dvec3& sum : sums) {
        const double length = glm::length(sum);
        normals.push_back(length > 0.0 ? glm::vec3(sum / length) : glm::vec3(0.0f, 1.0f, 0.0f));
    }
    return normals;
}

}  // namespace timeshade
