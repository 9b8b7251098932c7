#pragma once

#include "technique/prediction.h"

namespace timeshade {

/// What PublishedTuples holds of a triangle at a texel's centre, in double precision: the first and the last point in
/// time of its prism of flat triangles there, with times linear over those triangles, and NDC depths linear over the
/// map and in time between the two. A receiver's own triangle is left out. Without the coverage map.
class PublishedTuplesPrediction final : public Prediction {
  public:
    std::optional<double> casterDistance(const ReceiverInMap& receiver, std::size_t caster, const glm::dvec2& position,
                                         double u, double v) const override;
};

}  // namespace timeshade
