#pragma once

#include <cstdint>
#include <limits>

namespace timeshade {

/// A mean of the light's visibility over some domain of time and area, from rays spread evenly over it, each of which
/// counts by the shutter's response at its time. Points that do not face the light, or lie outside its cone, have no
/// visibility and no weight.
struct VisibilityMean {
    std::uint32_t tested = 0;  ///< rays that met a point which faces the light inside its cone
    std::uint32_t lit = 0;     ///< of those: the light is visible
    double weights = 0.0;      ///< of the tested, together; as many as they where all count alike
    double litWeights = 0.0;   ///< of the lit

    void add(bool isLit, double weight) {
        ++tested;
        weights += weight;
        if (!isLit) return;
        ++lit;
        litWeights += weight;
    }
    bool exists() const { return tested > 0; }
    /// 0 to 1; NaN where no point was tested.
    double value() const { return exists() ? litWeights / weights : std::numeric_limits<double>::quiet_NaN(); }
};

}  // namespace timeshade
