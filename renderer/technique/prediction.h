#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "technique/footprint.h"
#include "technique/sampling_traits.h"

namespace timeshade {

/// A point that moves, as the light's map sees it: (x w, y w, w) for the map position (x, y) in [0, 1]^2 and the
/// distance w along the light's axis, world units. Linear in u, as the axes of a light are constant during a shutter.
struct PathInMap {
    glm::dvec3 open, close;
    glm::dvec3 at(double u) const { return glm::mix(open, close, u); }
};

struct TriangleInMap {
    PathInMap corners[3];
};

/// Where the line from the light through a map position meets a triangle's plane.
struct PlaneHit {
    bool inside = false;    ///< of the triangle; its edges count, a triangle seen edge-on has no inside
    double distance = 0.0;  ///< along the light's axis; negative behind the light, not finite where there is none
    glm::dvec3 inMap;       ///< weights of the corners, for what is linear over the map
    glm::dvec3 inSpace;     ///< for what is linear over the triangle: barycentric coordinates
};

/// At time u.
inline PlaneHit hitOf(const TriangleInMap& triangle, const glm::dvec2& position, double u) {
    glm::dvec2 q[3];
    glm::dvec3 distances, e;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 corner = triangle.corners[i].at(u);
        q[i] = glm::dvec2(corner) - position * corner.z;
        distances[i] = corner.z;
    }
    for (int i = 0; i < 3; ++i) {
        const glm::dvec2 &a = q[(i + 1) % 3], &b = q[(i + 2) % 3];
        e[i] = a.x * b.y - a.y * b.x;
    }
    const double sum = e.x + e.y + e.z;
    const bool oneSign = (e.x >= 0 && e.y >= 0 && e.z >= 0) || (e.x <= 0 && e.y <= 0 && e.z <= 0);
    return {oneSign && sum != 0.0, glm::dot(e, distances) / sum, e * distances / glm::dot(e, distances), e / sum};
}

/// A point of a receiver, and all that may shadow it.
struct ReceiverInMap {
    const std::vector<TriangleInMap>& triangles;
    std::size_t own = 0;      ///< the triangle that the point lies in
    PathInMap path;           ///< the point is followed on that triangle
    glm::dvec2 mapSize{0.0};  ///< texels
    int strata = 0;
    double nearDistance = 0.0;  ///< the light's; nothing nearer casts a shadow in a map
    double texelAngle = 0.0;    ///< width of a texel at distance 1, of its longer side

    /// Centre of the texel that holds a position.
    glm::dvec2 texelCentre(const glm::dvec2& position) const {
        return (glm::floor(position * mapSize) + 0.5) / mapSize;
    }
};

/// What a technique does to casters that SamplingTraits cannot say, in double precision: a technique overrides what it
/// does otherwise. As it stands, a map that holds what its texels see.
class Prediction {
  public:
    Prediction() = default;
    Prediction(const Prediction&) = delete;
    Prediction& operator=(const Prediction&) = delete;
    virtual ~Prediction() = default;

    /// The distance along the light's axis at which a caster is found at a map position (with texelCentres, a texel's
    /// centre), for a receiver seen at time u and casters looked at at time v. Nothing: it is not there.
    virtual std::optional<double> casterDistance(const ReceiverInMap& receiver, std::size_t caster,
                                                 const glm::dvec2& position, [[maybe_unused]] double u,
                                                 double v) const {
        const PlaneHit hit = hitOf(receiver.triangles[caster], position, v);
        return hit.inside ? std::optional(hit.distance) : std::nullopt;
    }
    /// The technique's value for the receiver seen at time u, for what no test of single casters can say: visibilities
    /// that are filtered, multiplied or integrated. Nothing: it follows from the traits and casterDistance.
    virtual std::optional<double> lit(const ReceiverInMap&, [[maybe_unused]] double u) const { return std::nullopt; }
    /// Why nothing is predicted of casters finer than a texel or shorter in time than a step of integration. Nothing:
    /// they are seen where they cover a texel's centre.
    virtual std::optional<std::string> fineCastersUnpredicted() const { return std::nullopt; }
};

/// All that a prediction follows from.
struct TechniqueStatement {
    Footprint footprint;
    SamplingTraits traits;
    int renders = 1;  ///< as Technique::renders
    std::shared_ptr<const Prediction> prediction = std::make_shared<Prediction>();

    /// Every value is about one instant, whatever the times of the samples.
    bool isOfOneInstant() const { return traits.times == SamplingTraits::Times::OneInstant && renders == 1; }
    /// A receiver is held against casters of the whole shutter, whenever it is seen: right where it stands still in the
    /// light's frame.
    bool ignoresReceiverTime() const {
        return footprint.time == Footprint::Time::Shutter && traits.times == SamplingTraits::Times::RandomInStratum;
    }
};

}  // namespace timeshade
