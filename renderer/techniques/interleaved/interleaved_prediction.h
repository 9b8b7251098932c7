#pragma once

#include "technique/prediction.h"

namespace timeshade {

/// The mean of the P^2 tests of a slice, each at its own time and in its own texel.
class InterleavedPrediction final : public Prediction {
  public:
    struct Form {
        int side;    ///< P
        int strata;  ///< slices of the shutter; 0: as many as a pixel has camera samples
        int pcfRadius;
        double biasTexels;
        bool planeTest;
    };
    explicit InterleavedPrediction(const Form& form) : form_(form) {}
    std::optional<double> lit(const ReceiverInMap& receiver, double u) const override;

  private:
    double litInPhase(const ReceiverInMap& receiver, int phase, double time) const;
    bool isLit(const ReceiverInMap& receiver, const glm::dvec2& centre, double time) const;

    Form form_;
};

}  // namespace timeshade
