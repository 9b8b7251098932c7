#pragma once

#include <utility>
#include <vector>

#include "scenes/runner_body.h"

namespace timeshade {

/// A round track on the ground, about the origin.
struct Track {
    double radius = 4.2;

    /// The place so far along it, at the origin's right hand, and so far outside of its middle.
    glm::dvec3 at(double along, double outside) const;
    /// The axes of someone who runs there: left, up, forwards.
    glm::dmat3 heading(double along) const;
};

/// How far two steps go, in metres.
inline constexpr double strideLength = 2.25;

/// The bones of someone who runs on the track and has made so many pairs of steps; feet on the ground stand still.
std::vector<RigidPose> runningPose(double strides, const Track& track);

/// The least radius from `least` on with which a round is a whole number of strides, and that number.
std::pair<double, int> roundTrack(double least);

}  // namespace timeshade
