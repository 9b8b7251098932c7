#pragma once

#include "technique/prediction.h"

namespace timeshade {

/// A map that is fitted to what the camera sees has texels finer than the light's by an amount that only the frame
/// knows.
class FittedMapPrediction final : public Prediction {
  public:
    std::optional<std::string> fineCastersUnpredicted() const override {
        return "what a map fitted to the picture catches of a caster finer than the light's own texels is not "
               "predicted";
    }
};

}  // namespace timeshade
