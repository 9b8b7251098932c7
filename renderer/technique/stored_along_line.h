#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gl/texture.h"
#include "plan/map_line.h"

namespace timeshade {

/// Something that a technique stored: a part of a line in the light's map, a time or an interval of time, and how far
/// from the light. Distances are those from the light's plane along its axis, in world units; u outside of
/// [0, 1] is before or after the shutter.
struct StoredMark {
    double xFrom = 0.0, xTo = 1.0;          ///< along the line, in [0, 1]
    double uFrom = 0.0, uTo = 1.0;          ///< at the centre of that part; equal for what holds at one instant only
    double depthFrom = 0.0, depthTo = 0.0;  ///< at uFrom and at uTo; linear in u between them
    /// By how much uFrom and uTo change from xFrom to xTo, where the technique extrapolates times inside a texel.
    double uFromSlope = 0.0, uToSlope = 0.0;
    double opacity = 1.0;                  ///< share of the light that it stops, in [0, 1]
    std::uint32_t triangle = NO_TRIANGLE;  ///< whose it is, where the technique knows that
    bool operator==(const StoredMark&) const = default;
};

/// What a technique stored along a line, in any order. For the epipolar view.
struct StoredAlongLine {
    std::vector<StoredMark> marks;
    std::string note;  ///< what the marks stand for, and what of the technique they leave out: one line; may be empty
};

/// The distance that a stored depth of the light's map stands for (lib/light_projection.glsl); infinity where nothing
/// was drawn.
double distanceOfStored(const FramePlan& plan, float stored);

/// One layer of a texture of floats or depths in these texels, in their order. Waits for the device.
std::vector<float> valuesAlong(const gl::Texture& map, int layer, const std::vector<TexelOnLine>& texels);

/// Adds what an ordinary map of depths holds along a line, for all of [uFrom, uTo]; nothing where it holds nothing.
void addMapMarks(const FramePlan& plan, const gl::Texture& map, const MapLine& line, double uFrom, double uTo,
                 std::vector<StoredMark>& marks);

}  // namespace timeshade
