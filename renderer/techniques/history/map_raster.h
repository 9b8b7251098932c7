#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include "passes/map_fit.h"

namespace timeshade {

/// How one frame's shadow map differs from the next one's.
enum class MapJitter {
    None,
    Shift,         ///< by less than a texel
    ShiftAndTurn,  ///< and turned by less than a right angle (Scherzer et al. 2007, section 3.3)
};

/// Element `index` of the van der Corput sequence in the given base, in [0, 1); element 0 is 0.
double radicalInverse(std::uint32_t base, std::uint32_t index);

/// The map of rasterisation `index`: Halton's sequence in bases 2 and 3 for the shift, 5 for the angle. A map that is
/// fitted to the camera's view alone (MapFit::Seen) covers the light's whole reach while camera or light move within
/// the shutter; its shortfall says so.
FittedMap mapRaster(const FramePlan& plan, MapFit fit, MapJitter jitter, std::uint32_t index);

}  // namespace timeshade
