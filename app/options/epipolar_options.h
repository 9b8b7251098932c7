#pragma once

#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "options/picture_options.h"
#include "options/run_options.h"
#include "plan/map_line.h"

namespace timeshade {

/// `timeshade epipolar`: what lies along a line of the light's map over the shutter, in truth and as stored.
struct EpipolarOptions : PictureOptions, RunOptions {
    std::string output;
    std::optional<MapLine> line;      ///< of --line or --row; else of the pixel, or the map's middle row
    std::optional<glm::uvec2> pixel;  ///< from the left and from the top of the picture, inside it
};

}  // namespace timeshade
