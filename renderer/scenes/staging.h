#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "scenes/mesh_scene.h"

namespace timeshade {

/// Parts that the computed scenes share: diffuse materials, a ground, a static spot light, and motion in whole rounds,
/// so that every scene loops without a jump.

constexpr double pi = 3.14159265358979323846;

Material matt(std::string name, const glm::vec3& colour, float roughness = 0.85f);

/// A square of ground in the plane y = 0, centred on the origin.
MeshInstance ground(double side, std::uint32_t material);

/// A static spot light. Cone angles in radians from the axis.
std::function<LightPose(double)> staticSpot(const glm::dvec3& position, const glm::dvec3& target, double innerCone,
                                            double outerCone);

std::function<CameraPose(double)> staticCamera(const glm::dvec3& eye, const glm::dvec3& target,
                                               double verticalFieldOfView);

/// The rotation by an angle (radians) about a unit vector.
glm::dmat3 turnAbout(const glm::dvec3& axis, double angle);

/// Uniform motion there and back: rises from 0 to 1 while phase goes from 0 to 1/2, sinks again until 1, and repeats.
double backAndForth(double phase);

/// Uniform motion on a circle, `rounds` times in a scene's duration.
struct Circle {
    int rounds = 0;  ///< 0: static, at the centre
    double radius = 0.0;

    /// The circle on which the chord of one frame has this length, with a radius as close to the wanted one as a whole
    /// number of rounds in `frames` allows. The chord is the path of a vertex in a shutter of one frame.
    static Circle withChord(double chord, double wantedRadius, int frames);
};

/// Random numbers that are functions of the seed, the object and the property only.
class Dice {
  public:
    Dice(std::uint32_t seed, std::uint32_t thing) : seed_(seed), thing_(thing) {}

    double share();  ///< the next number in [0, 1)
    double between(double low, double high) { return low + (high - low) * share(); }
    glm::dvec3 direction();  ///< a unit vector, all directions equally likely
    std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(share() * count); }

  private:
    std::uint32_t seed_, thing_, property_ = 0;
};

}  // namespace timeshade
