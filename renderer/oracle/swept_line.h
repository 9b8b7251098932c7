#pragma once

#include "oracle/polynomial.h"
#include "oracle/swept_bvh.h"

namespace timeshade::oracle {

/// A line that moves: through p(t) along l(t), t in [0, 1], both times one common factor. The points q on it have
/// q x l = p x l, three equations that are linear in q.
class SweptLine {
  public:
    /// `direction` is l, `moment` is p x l; of a degree one higher, at most 6.
    SweptLine(const VectorPolynomial& direction, const VectorPolynomial& moment);

    /// True only if the line meets the box, enlarged by `pad` on all sides, at no time. The box moves linearly from its
    /// one end at t = 0 to its other at t = 1.
    bool misses(const SweptBox& box, double pad) const;

  private:
    static constexpr int most = 7;
    int degree_;  ///< of the moment
    double direction_[3][most]{}, moment_[3][most]{};
};

}  // namespace timeshade::oracle
