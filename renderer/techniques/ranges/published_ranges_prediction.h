#pragma once

#include "technique/prediction.h"

namespace timeshade {

/// What LinkedRanges holds of a triangle at a texel's centre, in double precision: the points of its prism there, with
/// times linear over its faces and NDC depths linear over the map, sorted by depth; a range for every two of the first
/// four, with NDC depths linear in time. A receiver's own triangle is left out.
class PublishedRangesPrediction final : public Prediction {
  public:
    /// Of ranges that hold u, the nearest.
    std::optional<double> casterDistance(const ReceiverInMap& receiver, std::size_t caster, const glm::dvec2& position,
                                         double u, double v) const override;
};

}  // namespace timeshade
