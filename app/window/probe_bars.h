#pragma once

#include <vector>

namespace timeshade {

/// A technique's value for one camera sample, and the true mean over the same footprint.
struct ProbeValue {
    float from = 0.0f, to = 0.0f;      ///< the footprint's interval of the shutter, in u; equal for an instant
    float lit = -1.0f, truth = -1.0f;  ///< 0 to 1; negative where there is none
    float weight = 1.0f;               ///< of the sample in its pixel: the shutter's response at its time
};

/// A rectangle of a strip, in shares of the strip's width and height from its upper left corner, and its grey, 0 to 1.
struct ProbeBar {
    float left = 0.0f, right = 1.0f, top = 0.0f, bottom = 1.0f, grey = 0.0f;
};

/// The values, or the truths, of a pixel over the shutter, which is as wide as the strip. A value over an interval is a
/// bar as wide as the interval; a value at an instant is a mark of width `mark` around it. Values over one interval lie
/// one below the other, the most lit uppermost, and the truths in the order of their values. Samples without a value
/// are left out.
std::vector<ProbeBar> barsOf(std::vector<ProbeValue> values, float ProbeValue::*shown, float mark);

}  // namespace timeshade
