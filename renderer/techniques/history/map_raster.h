#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include "plan/frame_plan.h"

namespace timeshade {

/// How one frame's shadow map differs from the next one's.
enum class MapJitter {
    None,
    Shift,         ///< by less than a texel
    ShiftAndTurn,  ///< and turned by less than a right angle (Scherzer et al. 2007, section 3.3)
};

/// What the map covers.
enum class MapFit {
    Light,   ///< all that the light reaches
    Seen,    ///< what the camera can see of it
    Warped,  ///< that, with more texels for what is near the camera: light space perspective (Wimmer, Scherzer,
             ///< Purgathofer 2004)
};

/// Element `index` of the van der Corput sequence in the given base, in [0, 1); element 0 is 0.
double radicalInverse(std::uint32_t base, std::uint32_t index);

/// The homography from (s, t, 1) of the light's map plane to the map of rasterisation `index`: Halton's sequence in
/// bases 2 and 3 for the shift, 5 for the angle. Its weight is at least 1 inside the map (where there is no warp, it is
/// 1). Whatever is to be covered stays inside: a spot's cone is round and so fits a turned square; a directional
/// light's square shrinks to fit, by 1 / (cos + sin) of the angle, 0.79 in the mean. The warp is the weaker the more
/// light and camera look along one line, and ends where they do (duelling frusta): then Warped is Seen.
glm::dmat3 mapRaster(const FramePlan& plan, MapFit fit, MapJitter jitter, std::uint32_t index);

}  // namespace timeshade
