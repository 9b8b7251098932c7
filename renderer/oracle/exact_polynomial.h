#pragma once

#include <vector>

#include "oracle/expansion.h"
#include "oracle/polynomial.h"

namespace timeshade::oracle {

/// A polynomial over [0, 1] whose coefficients are kept exactly. Slow: for the few that cancel in `Real`.
class ExactPolynomial {
  public:
    /// The linear function from one value to another.
    ExactPolynomial(const Expansion& open, const Expansion& close) : scaled_{open, close} {}

    Polynomial rounded() const;  ///< each coefficient to within an ulp or two of a double
    int signAt(double u) const;  ///< -1, 0 or 1: without any rounding

    ExactPolynomial operator*(const ExactPolynomial& other) const;
    ExactPolynomial operator*(double factor) const;
    ExactPolynomial operator+(const ExactPolynomial& other) const;  ///< of one degree
    ExactPolynomial operator-(const ExactPolynomial& other) const;  ///< of one degree

  private:
    explicit ExactPolynomial(std::vector<Expansion> scaled) : scaled_(std::move(scaled)) {}
    std::vector<Expansion> scaled_;  ///< Bernstein coefficients times binomial coefficients
};

/// Three coordinates.
struct ExactWay {
    ExactPolynomial x, y, z;
    /// The difference of two points that move straight, without rounding.
    static ExactWay difference(const glm::dvec3 (&a)[2], const glm::dvec3 (&b)[2]);
    /// A point or direction that moves straight.
    static ExactWay of(const glm::dvec3 (&a)[2]);
};

/// a . (b x c).
ExactPolynomial determinant(const ExactWay& a, const ExactWay& b, const ExactWay& c);

}  // namespace timeshade::oracle
