#pragma once

#include "technique/prediction.h"

namespace timeshade {

/// Four tests about the receiver, weighted bilinearly, or one; the receiver's own triangle is left out. In double
/// precision.
class IntervalsPrediction : public Prediction {
  public:
    IntervalsPrediction(bool bilinear, double biasTexels) : bilinear_(bilinear), biasTexels_(biasTexels) {}
    std::optional<double> lit(const ReceiverInMap& receiver, double u) const override;

  private:
    bool bilinear_;
    double biasTexels_;
};

/// As far nearer or farther than the receiver as the caster is than the receiver's plane, both through the texel's
/// centre at the receiver's time.
class PlaneIntervalsPrediction final : public IntervalsPrediction {
  public:
    using IntervalsPrediction::IntervalsPrediction;
    std::optional<double> casterDistance(const ReceiverInMap& receiver, std::size_t caster, const glm::dvec2& position,
                                         double u, double v) const override;
};

/// As published: the distance is linear between the times at which the caster begins and ends to cover the texel's
/// centre, or over each of `pieces` equal parts of that. Intervals are not merged.
class PublishedIntervalsPrediction final : public IntervalsPrediction {
  public:
    PublishedIntervalsPrediction(bool bilinear, double biasTexels, int pieces)
        : IntervalsPrediction(bilinear, biasTexels), pieces_(pieces) {}
    std::optional<double> casterDistance(const ReceiverInMap& receiver, std::size_t caster, const glm::dvec2& position,
                                         double u, double v) const override;

  private:
    int pieces_;
};

}  // namespace timeshade
