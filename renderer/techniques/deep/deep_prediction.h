#pragma once

#include "technique/prediction.h"

namespace timeshade {

/// What a deep shadow map says, in double precision and without its noise and compression: the share of the shutter
/// during which, at the centre of the receiver's texel, nothing is nearer to the light than the receiver's depth at its
/// own time, less the bias. Casters move, the receiver does not: that is the technique's error.
class DeepPrediction final : public Prediction {
  public:
    /// biasTexels: in texels at the receiver's depth. radius: of the filter of (2 radius + 1)^2 texels.
    DeepPrediction(double biasTexels, int radius) : biasTexels_(biasTexels), radius_(radius) {}

    std::optional<double> lit(const ReceiverInMap& receiver, double u) const override;

  private:
    double biasTexels_;
    int radius_;
};

}  // namespace timeshade
