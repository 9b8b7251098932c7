#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

namespace timeshade {

/// When a moving triangle shadows a moving receiver, in double precision: the judge of shared/time_integral.shared.h,
/// of which it shares nothing. Its polynomials are known by their values at four times, its roots are found between the
/// roots of derivatives, and every end is where the definition itself changes.
class ShadowedTimes {
  public:
    using Interval = std::pair<double, double>;
    struct Motion {
        glm::dvec3 light[2], vertices[3][2];  ///< from the receiver; at t = 0 and at t = 1, linear between
        double clearance = 0.0;
    };

    explicit ShadowedTimes(const Motion& motion) : m_(motion) {}

    /// Intervals of [0, 1] in ascending order.
    std::vector<Interval> intervals() const {
        std::vector<double> cuts{0.0, 1.0};
        for (int k = 1; k < 16; ++k) cuts.push_back(k / 16.0);
        for (int which = 0; which < polynomials; ++which) addRoots(which, 0.0, cuts);
        std::sort(cuts.begin(), cuts.end());
        std::vector<Interval> found;
        double middleBefore = 0.0;
        bool before = false;
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            if (cuts[i + 1] - cuts[i] < 1e-13) continue;
            const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
            const bool now = shadows(middle);
            if (now && !before) found.emplace_back(middleBefore > 0.0 ? change(middleBefore, middle) : 0.0, 1.0);
            if (!now && before) found.back().second = change(middleBefore, middle);
            before = now;
            middleBefore = middle;
        }
        return found;
    }

    /// Times at which a polynomial is so near to 0 that floats may take it for the other sign.
    std::vector<Interval> doubtful() const {
        std::vector<Interval> found;
        for (int which = 0; which < polynomials; ++which) {
            const double limit = doubt(which);
            std::vector<double> cuts{0.0, 1.0};
            addRoots(which, limit, cuts);
            addRoots(which, -limit, cuts);
            std::sort(cuts.begin(), cuts.end());
            for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
                if (std::abs(value(which, 0.5 * (cuts[i] + cuts[i + 1]))) <= limit)
                    found.emplace_back(cuts[i], cuts[i + 1]);
        }
        return found;
    }

    bool shadows(double t) const {
        const double e[3] = {value(0, t), value(1, t), value(2, t)};
        const bool oneSign = (e[0] >= 0 && e[1] >= 0 && e[2] >= 0) || (e[0] <= 0 && e[1] <= 0 && e[2] <= 0);
        const glm::dvec3 n = normal(t);
        const double w = glm::dot(n, vertex(0, t)), v = glm::dot(n, light(t)), side = v < 0.0 ? -1.0 : 1.0;
        return oneSign && side * w > m_.clearance * glm::length(n) && side * w < side * v;
    }

    /// Length of a union.
    static double measure(std::vector<Interval> all) {
        std::sort(all.begin(), all.end());
        double sum = 0.0, reached = 0.0;
        for (const auto& [begin, end] : all) {
            sum += std::max(0.0, end - std::max(begin, reached));
            reached = std::max(reached, end);
        }
        return sum;
    }

  private:
    static constexpr int polynomials = 5;  // three edges, the plane at the receiver, the plane at the light

    glm::dvec3 vertex(int i, double t) const { return glm::mix(m_.vertices[i][0], m_.vertices[i][1], t); }
    glm::dvec3 light(double t) const { return glm::mix(m_.light[0], m_.light[1], t); }
    glm::dvec3 normal(double t) const { return glm::cross(vertex(1, t) - vertex(0, t), vertex(2, t) - vertex(0, t)); }
    double value(int which, double t) const {
        if (which < 3) return glm::dot(light(t), glm::cross(vertex((which + 1) % 3, t), vertex((which + 2) % 3, t)));
        return glm::dot(normal(t), which == 3 ? vertex(0, t) : vertex(0, t) - light(t));
    }

    /// What 2^-20 of the sizes of its terms makes: four times less than the header's bound.
    double doubt(int which) const {
        double far = glm::length(m_.light[0]) + glm::length(m_.light[1]), across = 0.0, edge = 0.0;
        for (int i = 0; i < 3; ++i)
            for (int end = 0; end < 2; ++end) {
                across = std::max(across, glm::length(m_.vertices[i][end]));
                edge = std::max(edge, glm::length(m_.vertices[i][end] - m_.vertices[(i + 1) % 3][end]));
            }
        if (which < 3) return std::ldexp(far * across * edge, -20);
        return std::ldexp(edge * edge * (which == 3 ? across : far + across), -20) + 2.0 * m_.clearance * edge * edge;
    }

    double changeOf(int which, double shift, double low, double high) const {
        const bool positive = value(which, low) > shift;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            ((value(which, middle) > shift) == positive ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }
    /// Roots of the polynomial less `shift` inside (0, 1).
    void addRoots(int which, double shift, std::vector<double>& cuts) const {
        const double y[4] = {value(which, 0.0), value(which, 1.0 / 3.0), value(which, 2.0 / 3.0), value(which, 1.0)};
        // y(t) = y0 + c1 t + c2 t^2 + c3 t^3 through the four values.
        const double c3 = 4.5 * (y[3] - 3.0 * y[2] + 3.0 * y[1] - y[0]);
        const double c2 = 4.5 * (y[0] - 2.0 * y[1] + y[2]) - c3;
        const double c1 = y[3] - y[0] - c2 - c3;
        std::vector<double> turns{0.0, 1.0};
        const double root = c2 * c2 - 3.0 * c1 * c3;
        if (root >= 0.0) {
            const double q = -(c2 + std::copysign(std::sqrt(root), c2));
            for (const double t : {q / (3.0 * c3), c1 / q})
                if (t > 0.0 && t < 1.0) turns.push_back(t);
        }
        std::sort(turns.begin(), turns.end());
        for (std::size_t i = 0; i + 1 < turns.size(); ++i)
            if ((value(which, turns[i]) > shift) != (value(which, turns[i + 1]) > shift))
                cuts.push_back(changeOf(which, shift, turns[i], turns[i + 1]));
    }
    double change(double low, double high) const {
        const bool first = shadows(low);
        for (int i = 0; i < 50; ++i) {
            const double middle = 0.5 * (low + high);
            (shadows(middle) == first ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

    Motion m_;
};

}  // namespace timeshade
