#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "plan/frame_plan.h"

namespace timeshade {

/// The triangles that move before the camera, and for every tile of side x side pixels and every
/// bucket of time those that may be seen in it, in ascending order of their ids. Conservative: a slack of 1/64 pixel
/// covers the rounding of a projection. What the camera does not see move is in no list.
struct SeenTiles {
    int side = 8;  ///< of a tile in pixels, a power of two: smaller where lists would be long
    int columns = 0, rows = 0;
    int buckets = 1;                     ///< parts of the shutter, equally long
    std::vector<glm::vec4> triangles;    ///< TRIANGLE_POSITION_TEXELS each, as MeshTexels has them, in view coordinates
    std::vector<std::uint32_t> ids;      ///< of the mesh
    std::vector<std::uint32_t> offsets;  ///< of each tile's lists, one a bucket, tiles row by row from the bottom;
                                         ///< and the end of the last
    std::vector<glm::u32vec2> candidates;  ///< a triangle's number here, and its bounds in the tile: low x, low y, high
                                           ///< x, high y in 255ths, rounded outwards, from the lowest byte on
};

SeenTiles seenTiles(const FramePlan& plan);

}  // namespace timeshade
