#pragma once

#include <vector>

namespace timeshade::oracle {

/// A real number kept exactly, as a sum of doubles that do not overlap, smallest first (Shewchuk 1997, "Adaptive
/// Precision Floating-Point Arithmetic"). Slow: for the few signs that plain double precision cannot tell.
/// Exact as long as no partial product underflows. Needs round-to-nearest and no contraction of a * b + c.
class Expansion {
  public:
    Expansion() = default;
    explicit Expansion(double value) { add(value); }

    /// a - b, without rounding.
    static Expansion difference(double a, double b);

    Expansion& operator+=(const Expansion& other);
    Expansion& operator-=(const Expansion& other);
    Expansion operator*(const Expansion& other) const;
    Expansion operator*(double factor) const;

    int sign() const;         ///< -1, 0 or 1
    double estimate() const;  ///< to within an ulp or so

  private:
    void add(double value);
    std::vector<double> parts_;
};

/// Three coordinates without rounding.
struct ExactVector {
    Expansion x, y, z;
};

/// a . (b x c).
Expansion determinant(const ExactVector& a, const ExactVector& b, const ExactVector& c);

}  // namespace timeshade::oracle
