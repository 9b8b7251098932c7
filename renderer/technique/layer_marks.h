#pragma once

#include <cstdint>
#include <functional>

#include "technique/stored_along_line.h"

namespace timeshade {

/// Adds what the layers of a map of depths hold along a line, each texel of each layer at one instant of its own, which
/// `timeOf` tells; nothing where a texel holds nothing. Waits for the device.
void addLayerMarks(const FramePlan& plan, const gl::Texture& map, const MapLine& line,
                   const std::function<float(glm::uvec2 texel, std::uint32_t layer)>& timeOf,
                   std::vector<StoredMark>& marks);

}  // namespace timeshade
