#pragma once

#include <cstdint>

#include "oracle/sample_index.h"
#include "shared/frame_blocks.shared.h"

namespace timeshade {

/// What a mean at a camera sample is taken over.
struct SampleFootprint {
    enum class Space {
        /// The point that the sample sees, followed through time as a point of its triangle: barycentrics fixed,
        /// whether or not the camera still sees it.
        Point,
        /// All that the pixel's area sees of the surface that the sample sees. A surface is one mesh instance: at each
        /// time those places of the pixel count whose camera ray first meets a triangle of the sample's instance.
        PixelSurface
    };
    SampleIndex sample;
    std::uint32_t triangle = NO_TRIANGLE;  ///< that the sample sees
    float from = 0.0f, to = 1.0f;          ///< shutter times u, 0 <= from <= to <= 1
    Space space = Space::Point;
};

}  // namespace timeshade
