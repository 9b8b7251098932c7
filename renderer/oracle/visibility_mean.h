#pragma once

#include <cstdint>
#include <limits>

namespace timeshade {

/// A mean of the light's visibility over some domain of time and area, from rays spread evenly over it. Points that do
/// not face the light, or lie outside its cone, have no visibility and no weight.
struct VisibilityMean {
    std::uint32_t tested = 0;  ///< rays that met a point which faces the light inside its cone
    std::uint32_t lit = 0;     ///< of those: the light is visible

    bool exists() const { return tested > 0; }
    /// 0 to 1; NaN where no point was tested.
    double value() const {
        return exists() ? static_cast<double>(lit) / static_cast<double>(tested)
                        : std::numeric_limits<double>::quiet_NaN();
    }
};

}  // namespace timeshade
