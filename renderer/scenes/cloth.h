#pragma once

#include <memory>

#include "scenes/flesh.h"
#include "scenes/rigid_pose.h"
#include "scenes/shape.h"

namespace timeshade {

/// A cloth that hangs from a rod and waves in the wind: whole waves in a period, so that it repeats.
struct Cloth {
    double width = 1.0, height = 2.0;
    int columns = 24, rows = 36;
    double size = 0.18;   ///< of the largest wave, at the free end
    double period = 1.0;  ///< seconds after which everything repeats
    int waves = 3;        ///< in a period
    double phase = 0.0;   ///< in waves
    RigidPose place;      ///< of the rod's middle: x along it, y up, z the way the wind blows
};

/// Hanging still, in the cloth's own place: 2 columns x rows triangles, seen from both sides.
std::shared_ptr<const Shape> hangingCloth(const Cloth& cloth);
/// How the vertices of that shape wave.
std::shared_ptr<const Flesh> wavingCloth(const Cloth& cloth);

}  // namespace timeshade
