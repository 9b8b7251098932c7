#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace timeshade {

/// How the vertices of a shape move as functions of time, each by itself. Safe to read from several threads.
class Flesh {
  public:
    virtual ~Flesh() = default;
    /// Writes where these vertices of the shape are, in the world, and their unit normals unless `normals` is null.
    virtual void bend(double seconds, const std::vector<std::uint32_t>& vertices, glm::dvec3* positions,
                      glm::vec3* normals) const = 0;
    /// How far any part turns on its way from one time to another, in degrees, at most 180.
    virtual double turn(double fromSeconds, double toSeconds) const = 0;
};

}  // namespace timeshade
