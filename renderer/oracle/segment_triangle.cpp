#include "oracle/segment_triangle.h"

#include <algorithm>
#include <cmath>

#include "oracle/expansion.h"

namespace timeshade::oracle {

namespace {

/// Bound on the rounding error of a determinant of three rounded differences, relative to the sum of its products'
/// magnitudes. Seven half ulps are enough (Shewchuk 1997, section 4.3, for the same expression); this is twice that.
constexpr double determinantError = 14.0 * 1.1102230246251565e-16;

struct Determinant {
    double value = 0.0;
    double error = 0.0;  ///< |value - exact| is not more
};

/// det[d, a, b], given c = a x b and the sums of magnitudes of its two products, component by component.
Determinant determinantOf(const glm::dvec3& d, const glm::dvec3& a, const glm::dvec3& b) {
    const double yz = a.y * b.z, zy = a.z * b.y, zx = a.z * b.x, xz = a.x * b.z, xy = a.x * b.y, yx = a.y * b.x;
    const double magnitude = std::abs(d.x) * (std::abs(yz) + std::abs(zy)) +
                             std::abs(d.y) * (std::abs(zx) + std::abs(xz)) +
                             std::abs(d.z) * (std::abs(xy) + std::abs(yx));
    return {d.x * (yz - zy) + d.y * (zx - xz) + d.z * (xy - yx), determinantError * magnitude};
}

ExactVector exactDifference(const glm::dvec3& a, const glm::dvec3& b) {
    return {Expansion::difference(a.x, b.x), Expansion::difference(a.y, b.y), Expansion::difference(a.z, b.z)};
}

int signOf(double value) { return value > 0.0 ? 1 : (value < 0.0 ? -1 : 0); }

/// One segment against one triangle. e_i = det[to - from, v_j - from, v_k - from] tells on which side of edge i the
/// line passes; W = det[v0 - from, v1 - from, v2 - from] and E = e_0 + e_1 + e_2 give s = W / E (numerics D2).
class MeetingTest {
  public:
    MeetingTest(const Segment& segment, const glm::dvec3 (&vertices)[3]) : segment_(segment), vertices_(vertices) {
        direction_ = segment.to - segment.from;
        for (int i = 0; i < 3; ++i) w_[i] = vertices[i] - segment.from;
    }

    Meeting result() {
        Meeting meeting;
        if (passesOutside()) return meeting;
        const bool inside = passesInside();
        const int sum = inside ? signOf(static_cast<double>(edgeSign_[0] + edgeSign_[1] + edgeSign_[2])) : 0;
        const double sumEstimate = edge_[0].value + edge_[1].value + edge_[2].value;
        const Determinant plane = determinantOf(w_[0], w_[1], w_[2]);
        const double area = glm::length(glm::cross(w_[1] - w_[0], w_[2] - w_[0]));
        const double planeSlack = marginalShare * scale_ * area;
        // Signed areas times how far the plane lies beyond the one end and before the other; positive between them.
        const double direction = sum != 0 ? static_cast<double>(sum) : (sumEstimate < 0.0 ? -1.0 : 1.0);
        const double beyondLow = direction * (plane.value - segment_.low * sumEstimate) - segment_.clearance * area;
        const double beforeHigh =
            std::isinf(segment_.high) ? HUGE_VAL : direction * (segment_.high * sumEstimate - plane.value);
        if (std::min(beyondLow, beforeHigh) < -std::max(planeSlack, sumError(plane))) return meeting;

        const bool clear = segment_.clearance == 0.0 || direction * plane.value > segment_.clearance * area;
        meeting.hit = inside && sum != 0 && clear && sum * planeSign(plane, segment_.low) > 0 &&
                      (std::isinf(segment_.high) || sum * planeSign(plane, segment_.high) < 0);
        meeting.marginal = nearEdge_ || std::min(beyondLow, beforeHigh) <= planeSlack;
        meeting.facing = sum < 0 ? 1 : -1;
        meeting.facingMarginal = std::abs(plane.value) <= planeSlack;
        meeting.s = sumEstimate != 0.0 ? plane.value / sumEstimate : 0.0;
        return meeting;
    }

  private:
    /// Clearly outside: the quick end of nearly every test.
    bool passesOutside() {
        const double farthest =
            std::sqrt(std::max({glm::dot(w_[0], w_[0]), glm::dot(w_[1], w_[1]), glm::dot(w_[2], w_[2])}));
        scale_ = glm::length(segment_.from) + std::min(segment_.reach, farthest);
        const double slack = marginalShare * scale_ * glm::length(direction_);
        bool positive = false, negative = false;
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 &a = w_[(i + 1) % 3], &b = w_[(i + 2) % 3];
            edge_[i] = determinantOf(direction_, a, b);
            const double edgeSlack = slack * glm::length(b - a);
            nearEdge_ = nearEdge_ || std::abs(edge_[i].value) <= edgeSlack;
            positive = positive || edge_[i].value > std::max(edgeSlack, edge_[i].error);
            negative = negative || edge_[i].value < -std::max(edgeSlack, edge_[i].error);
        }
        return positive && negative;
    }

    bool passesInside() {
        bool positive = false, negative = false;
        for (int i = 0; i < 3; ++i) {
            edgeSign_[i] = std::abs(edge_[i].value) > edge_[i].error ? signOf(edge_[i].value) : exactEdge(i).sign();
            positive = positive || edgeSign_[i] > 0;
            negative = negative || edgeSign_[i] < 0;
        }
        return positive != negative;
    }

    double sumError(const Determinant& plane) const {
        return plane.error + edge_[0].error + edge_[1].error + edge_[2].error;
    }

    Expansion exactEdge(int i) const {
        return determinant(exactDifference(segment_.to, segment_.from),
                           exactDifference(vertices_[(i + 1) % 3], segment_.from),
                           exactDifference(vertices_[(i + 2) % 3], segment_.from));
    }

    /// Sign of W - end * E: on which side of the plane the segment's point at s = end lies, relative to `from`.
    int planeSign(const Determinant& plane, double end) const {
        const double value = plane.value - end * (edge_[0].value + edge_[1].value + edge_[2].value);
        const double rounding =
            4e-16 * (std::abs(plane.value) +
                     std::abs(end) * (std::abs(edge_[0].value) + std::abs(edge_[1].value) + std::abs(edge_[2].value)));
        const double error =
            plane.error + std::abs(end) * (edge_[0].error + edge_[1].error + edge_[2].error) + rounding;
        if (std::abs(value) > error) return signOf(value);
        Expansion exact =
            determinant(exactDifference(vertices_[0], segment_.from), exactDifference(vertices_[1], segment_.from),
                        exactDifference(vertices_[2], segment_.from));
        for (int i = 0; i < 3; ++i) exact -= exactEdge(i) * end;
        return exact.sign();
    }

    const Segment& segment_;
    const glm::dvec3 (&vertices_)[3];
    glm::dvec3 direction_;
    glm::dvec3 w_[3];
    Determinant edge_[3];
    int edgeSign_[3] = {0, 0, 0};
    double scale_ = 0.0;
    bool nearEdge_ = false;
};

}  // namespace

Meeting meet(const Segment& segment, const glm::dvec3 (&vertices)[3]) {
    return MeetingTest(segment, vertices).result();
}

}  // namespace timeshade::oracle
