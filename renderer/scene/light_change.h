#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "scene/light.h"
#include "scene/scene.h"

namespace timeshade {

/// Where a light comes from, seen from the scene's centre, in degrees.
struct LightDirection {
    double azimuth = 0.0;    ///< about the vertical: 0 along +z, 90 along +x
    double elevation = 0.0;  ///< above the horizon, -90 to 90
    bool operator==(const LightDirection&) const = default;
};

/// What is other about a scene's light than in the scene. As it is made here, it changes nothing, to the last bit.
/// Angles are in degrees, so that what was typed comes back as it was.
struct LightChange {
    /// With a direction or a distance the light is placed anew, aimed at the scene's centre, and stands still there but
    /// for the motion below; what is not given is as in the scene at its own frame (Scene::defaults).
    std::optional<LightDirection> direction;
    std::optional<double> distance;  ///< of a spot from the scene's centre, world units, > 0
    std::optional<double> cone;      ///< of a spot, from its axis to its edge, leastCone .. mostCone
    double intensity = 1.0;          ///< times the scene's own, >= 0

    /// Motion, from where it is at the scene's own frame: of a spot's place, world units a frame, and of the direction,
    /// about the vertical (counter-clockwise from above) and upwards, degrees a frame.
    glm::dvec3 move{0.0};
    double turn = 0.0, rise = 0.0;
    /// Frames after the scene's own at which that motion stands still, for measurements without it.
    std::optional<double> heldAt;

    bool operator==(const LightChange&) const = default;
    bool moves() const { return move != glm::dvec3(0.0) || turn != 0.0 || rise != 0.0; }
    bool places() const { return direction.has_value() || distance.has_value(); }

    static constexpr double leastCone = 0.1, mostCone = 84.79;  ///< LightPose's largest is 1.48 radians
};

/// Unit vector towards the light.
glm::dvec3 vectorOf(const LightDirection& direction);
/// The inverse; `towards` is not 0. Straight up and down it has azimuth 0.
LightDirection directionOf(const glm::dvec3& towards);
/// Of a spot that of its place, of a sun that of its axis. What a light has before it is changed.
LightDirection directionOf(const LightPose& light, const glm::dvec3& centre);

/// The scene's light as it is at the scene's own frame, before any change.
LightPose lightAtOwnFrame(const Scene& scene);

/// `own`, the scene's light at some instant, with the change, that many frames after the scene's own frame.
/// `atOwnFrame` is lightAtOwnFrame().
LightPose changed(const LightPose& own, const LightPose& atOwnFrame, const LightChange& change,
                  const glm::dvec3& centre, double frames);

}  // namespace timeshade
