#include "oracle/swept_line.h"

#include <algorithm>

#include "core/check.h"

namespace timeshade::oracle {

SweptLine::SweptLine(const VectorPolynomial& direction, const VectorPolynomial& moment) : degree_(moment.x.degree()) {
    CHECK_EQ(direction.x.degree() + 1, degree_);
    CHECK_LT(degree_, most);
    const Polynomial *l[3] = {&direction.x, &direction.y, &direction.z}, *m[3] = {&moment.x, &moment.y, &moment.z};
    for (int c = 0; c < 3; ++c) {
        for (int i = 0; i < degree_; ++i) direction_[c][i] = static_cast<double>((*l[c])[i]);
        for (int i = 0; i <= degree_; ++i) moment_[c][i] = static_cast<double>((*m[c])[i]);
    }
}

bool SweptLine::misses(const SweptBox& box, double pad) const {
    for (int c = 0; c < 3; ++c) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;
        const double low[2][2] = {{box.low[0][a] - pad, box.low[1][a] - pad},
                                  {box.low[0][b] - pad, box.low[1][b] - pad}},
                     high[2][2] = {{box.high[0][a] + pad, box.high[1][a] + pad},
                                   {box.high[0][b] + pad, box.high[1][b] + pad}};
        // Bounds of the coefficients of q_a l_b - q_b l_a - m_c over the paths of the box's corners.
        double least = HUGE_VAL, greatest = -HUGE_VAL;
        for (int k = 0; k <= degree_; ++k) {
            const double late = static_cast<double>(k) / degree_, early = 1.0 - late;
            const double b0 = k < degree_ ? early * direction_[b][k] : 0.0,
                         b1 = k > 0 ? late * direction_[b][k - 1] : 0.0;
            const double a0 = k < degree_ ? early * direction_[a][k] : 0.0,
                         a1 = k > 0 ? late * direction_[a][k - 1] : 0.0;
            const double first[2] = {low[0][0] * b0 + low[0][1] * b1, high[0][0] * b0 + high[0][1] * b1};
            const double second[2] = {low[1][0] * a0 + low[1][1] * a1, high[1][0] * a0 + high[1][1] * a1};
            least = std::min(least, std::min(first[0], first[1]) - std::max(second[0], second[1]) - moment_[c][k]);
            greatest =
                std::max(greatest, std::max(first[0], first[1]) - std::min(second[0], second[1]) - moment_[c][k]);
        }
        if (least > 0.0 || greatest < 0.0) return true;
    }
    return false;
}

}  // namespace timeshade::oracle
