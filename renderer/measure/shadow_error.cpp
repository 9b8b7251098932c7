#include "measure/shadow_error.h"

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade {

ShadowError PixelMeans::against(const ReferenceVisibility& reference) const {
    if (reference.first.size() != sums_.size() || reference.second.size() != sums_.size())
        throw Error(
            fmt::format("cannot measure the shadow error: {} pixels against a reference of {}, expected as many",
                        sums_.size(), reference.first.size()));
    ShadowError result;
    result.rays = reference.rays;
    ErrorSum sum(sums_.size());
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        const bool sampled = weights_[i] > 0.0;
        if (sampled && reference.has(i)) {
            const double mean = sums_[i] / weights_[i];
            sum.add(i, mean - static_cast<double>(reference.first[i]), mean - static_cast<double>(reference.second[i]));
        } else if (reference.has(i)) {
            ++result.pixelsWithoutSamples;
        } else if (sampled) {
            ++result.pixelsWithoutReference;
        }
    }
    result.error = sum.summary();
    return result;
}

}  // namespace timeshade
