#include "oracle/receiver_way.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace timeshade::oracle {

namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

/// Noise of what is computed in few steps from numbers of its own size.
Real noiseOf(const Polynomial& p) { return std::ldexp(p.largest(), -50); }

}  // namespace

ReceiverWay::ReceiverWay(const FramePlan& plan, const PositionRay& ray, const SeenSegment& segment,
                         const MovingTriangles& triangles)
    : plan_(plan), ray_(ray), segment_(segment), triangles_(triangles) {
    origin_ = RealVector(receiverAt(0.5).answer.position);
    const VectorPolynomial v = vertexOf(segment.triangle, 0), a = vertexOf(segment.triangle, 1) - v,
                           b = vertexOf(segment.triangle, 2) - v;
    const VectorPolynomial eye = part(ray.eye[0], ray.eye[1], true);
    const VectorPolynomial d = part(ray.direction[0], ray.direction[1], false), w = v - eye;
    normal_ = cross(a, b);
    sum_ = dot(d, normal_);
    position_ = sum_ * eye + dot(w, normal_) * d;
    const Real area = a.largest() * b.largest();
    positionError_ = 512 * epsilon * d.largest() * area * (eye.largest() + w.largest());
    makeLight();
    makeExtent();
    line_.emplace(toLight_, moment_);
}

void ReceiverWay::makeLight() {
    if (plan_.lightOpen.kind == LightKind::Directional) {
        // The same at every place: `light_` is the way from a receiver to the far end.
        const glm::dvec3 any(0.0);
        const glm::dvec3 open = lightEnd(plan_, any, 0.0), close = lightEnd(plan_, any, 1.0);
        light_ = part(open, close, false);
        toLight_ = sum_ * light_;
    } else {
        light_ = part(lightEnd(plan_, {}, 0.0), lightEnd(plan_, {}, 1.0), true);
        toLight_ = sum_ * light_ - position_;
    }
    moment_ = cross(position_, light_);
    lightError_ = 8 * light_.largest() * (positionError_ + epsilon * position_.largest());
}

Receiver ReceiverWay::receiverAt(double t) const {
    return receiverOf(plan_, triangles_, rayAt(ray_, timeOf(t)), segment_.triangle);
}

VectorPolynomial ReceiverWay::part(const glm::dvec3& open, const glm::dvec3& close, bool asPoint) const {
    const auto at = [&](double u) {
        const RealVector there =
            RealVector(open) * (1 - static_cast<Real>(u)) + RealVector(close) * static_cast<Real>(u);
        return asPoint ? there - origin_ : there;
    };
    return VectorPolynomial::between(at(segment_.u0), at(segment_.u1));
}

VectorPolynomial ReceiverWay::vertexOf(std::uint32_t id, int vertex) const {
    return part(triangles_.end(id, vertex, false), triangles_.end(id, vertex, true), true);
}

void ReceiverWay::addTestedChanges(std::vector<double>& times) const {
    addRoots(sum_, noiseOf(sum_), times);
    const VectorPolynomial v = vertexOf(segment_.triangle, 0);
    const bool directional = plan_.lightOpen.kind == LightKind::Directional;
    // The receiver lies in its triangle's plane, so that any point of that will do.
    const Polynomial facing = dot(normal_, directional ? light_ : light_ - v);
    addRoots(facing, noiseOf(facing), times);
    if (directional) return;
    const VectorPolynomial back = part(plan_.lightOpen.axes[2], plan_.lightClose.axes[2], false);
    const auto cosine = static_cast<Real>(std::cos(plan_.lightOpen.outerConeAngle));
    const Polynomial along = dot(toLight_, back);
    const Polynomial border = along * along - (cosine * cosine) * (dot(toLight_, toLight_) * dot(back, back));
    addRoots(along, noiseOf(along), times);
    addRoots(border, noiseOf(border), times);
}

double ReceiverWay::clearanceAt(double t) const { return receiverAt(t).clearance; }

/// It follows the largest of the magnitudes of nine linear coordinates: their borders are among the times at which two
/// of these are equal.
std::vector<double> ReceiverWay::clearanceCuts() const {
    std::vector<double> cuts{0.0, 1.0};
    std::vector<std::pair<double, double>> ends;
    for (int v = 0; v < 3; ++v)
        for (int c = 0; c < 3; ++c) {
            const double open = triangles_.end(segment_.triangle, v, false)[c],
                         close = triangles_.end(segment_.triangle, v, true)[c];
            const auto at = [&](double u) { return open * (1.0 - u) + close * u; };
            ends.emplace_back(at(segment_.u0), at(segment_.u1));
            ends.emplace_back(-at(segment_.u0), -at(segment_.u1));
        }
    for (std::size_t i = 0; i < ends.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double open = ends[i].first - ends[j].first, close = ends[i].second - ends[j].second;
            if ((open < 0.0) == (close < 0.0) || open == close) continue;
            const double t = open / (open - close), both = ends[i].first * (1.0 - t) + ends[i].second * t;
            const bool below = std::any_of(ends.begin(), ends.end(), [&](const auto& end) {
                return end.first * (1.0 - t) + end.second * t > both + 1e-9 * std::abs(both);
            });
            if (!below) cuts.push_back(t);
        }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

Polynomial ReceiverWay::clearanceBetween(double t0, double t1) const {
    return {static_cast<Real>(clearanceAt(t0)), static_cast<Real>(clearanceAt(t1))};
}

/// A rational curve lies in the hull of its control points where the weights have one sign.
void ReceiverWay::makeExtent() {
    const Polynomial weights = sum_.elevated(4);
    low_ = glm::dvec3(HUGE_VAL);
    high_ = -low_;
    const auto add = [&](const RealVector& point) {
        low_ = glm::min(low_, glm::dvec3(point));
        high_ = glm::max(high_, glm::dvec3(point));
    };
    const bool oneSign = weights.least() > 0 || weights.greatest() < 0;
    if (oneSign && std::min(std::abs(weights.least()), std::abs(weights.greatest())) > weights.largest() / 1048576) {
        for (int i = 0; i <= 4; ++i) add(RealVector(position_.x[i], position_.y[i], position_.z[i]) / weights[i]);
    } else {
        for (int vertex = 0; vertex < 3; ++vertex)
            for (const Real t : {0, 1}) add(vertexOf(segment_.triangle, vertex).at(t));
    }
    const glm::dvec3 open(light_.at(0)), close(light_.at(1)), least = glm::min(open, close),
                                                              most = glm::max(open, close);
    const bool directional = plan_.lightOpen.kind == LightKind::Directional;
    low_ = glm::min(low_, directional ? low_ + least : least);
    high_ = glm::max(high_, directional ? high_ + most : most);
}

bool ReceiverWay::mayShadow(const SweptBox& box, double pad) const {
    SweptBox here;
    for (int end = 0; end < 2; ++end) {
        const double u = end == 0 ? segment_.u0 : segment_.u1;
        here.low[end] = box.low[0] * (1.0 - u) + box.low[1] * u - glm::dvec3(origin_);
        here.high[end] = box.high[0] * (1.0 - u) + box.high[1] * u - glm::dvec3(origin_);
    }
    for (int c = 0; c < 3; ++c)
        if (std::min(here.low[0][c], here.low[1][c]) - pad > high_[c] ||
            std::max(here.high[0][c], here.high[1][c]) + pad < low_[c])
            return false;
    return !line_->misses(here, pad);
}

}  // namespace timeshade::oracle
