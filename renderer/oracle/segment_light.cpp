#include "oracle/segment_light.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/receiver_way.h"
#include "oracle/segment_triangle.h"
#include "shared/shutter_response.shared.h"

namespace timeshade::oracle {

namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

/// The exposure from the opening until u, as a share of the whole.
double exposureUntil(const FramePlan& plan, double u) {
    if (plan.block.response == SHUTTER_TENT) return u < 0.5 ? 2.0 * u * u : 1.0 - 2.0 * (1.0 - u) * (1.0 - u);
    if (plan.block.response == SHUTTER_GAUSSIAN) {
        const double scale = std::sqrt(0.5) / static_cast<double>(plan.block.responseWidth);
        return 0.5 + 0.5 * std::erf((u - 0.5) * scale) / std::erf(0.5 * scale);
    }
    return u;
}

/// Calls work(t0, t1, middle) for each part of [0, 1] between two of the times.
template <class Work>
void forEachGap(std::vector<double>& times, const Work& work) {
    times.insert(times.end(), {0.0, 1.0});
    std::sort(times.begin(), times.end());
    for (std::size_t i = 0; i + 1 < times.size(); ++i)
        if (const std::optional<double> middle = timeBetween(times[i], times[i + 1]))
            work(times[i], times[i + 1], *middle);
}

void append(std::vector<TimeSpan>& spans, double begin, double end) {
    if (!spans.empty() && spans.back().end == begin)
        spans.back().end = end;
    else
        spans.push_back({begin, end});
}

/// When one triangle shadows the receiver: A . (v_i x v_j) + M . (v_j - v_i) of degree 6 is E times the determinant of
/// the segment and an edge's ends; E (n . v - n . p) and that less n . A, of degree 6 too, are the caster's plane at
/// the receiver and at the light.
class CasterTimes {
  public:
    CasterTimes(const ReceiverWay& way, std::uint32_t id) : way_(way), id_(id) {
        for (int i = 0; i < 3; ++i) v_[i] = way.vertexOf(id, i);
        for (int i = 0; i < 3; ++i) side_[i] = v_[(i + 2) % 3] - v_[(i + 1) % 3];
    }

    void addTo(std::vector<TimeSpan>& dark) {
        makeEdges();
        if (passesOutside()) return;
        makePlanes();
        if (isNotBetween()) return;
        std::vector<double> cuts;
        for (const Function& f : functions_) addRoots(f.p, std::max(f.error, 64 * epsilon * f.p.largest()), cuts);
        addClearance(cuts);
        forEachGap(cuts, [&](double t0, double t1, double middle) {
            if (shadows(middle)) append(dark, t0, t1);
        });
    }

  private:
    struct Function {
        Polynomial p;
        Real error = 0;
    };
    enum Which { Edge0, Edge1, Edge2, AtReceiver, AtLight, functions };

    void makeEdges() {
        const VectorPolynomial &a = way_.toLight(), &m = way_.moment();
        const Real aError = way_.positionError() + 8 * epsilon * a.largest();
        const Real half = static_cast<Real>(0.5);
        for (int i = 0; i < 3; ++i) {
            const VectorPolynomial &from = v_[(i + 1) % 3], &to = v_[(i + 2) % 3];
            const VectorPolynomial twice = cross(from + to, side_[i]);
            const Real size = side_[i].largest();
            functions_[i].p = half * dot(a, twice) + dot(m, side_[i]);
            functions_[i].error =
                16 * size * (aError * (from.largest() + to.largest()) + way_.lightError() + 8 * epsilon * m.largest());
        }
    }

    void makePlanes() {
        const VectorPolynomial& a = way_.toLight();
        const Real aError = way_.positionError() + 8 * epsilon * a.largest();
        normal_ = cross(side_[2], static_cast<Real>(-1) * Polynomial{1} * side_[1]);
        const Real area = side_[1].largest() * side_[2].largest();
        functions_[AtReceiver].p = way_.sum() * dot(normal_, v_[0]) - dot(normal_, way_.position());
        functions_[AtLight].p = functions_[AtReceiver].p - dot(normal_, a);
        functions_[AtReceiver].error =
            16 * area *
            (way_.positionError() +
             16 * epsilon * (way_.sum().largest() * v_[0].largest() + way_.position().largest()));
        functions_[AtLight].error = functions_[AtReceiver].error + 16 * area * aError;
    }

    bool isAbove(Which which) const { return functions_[which].p.least() > functions_[which].error; }
    bool isBelow(Which which) const { return functions_[which].p.greatest() < -functions_[which].error; }

    bool passesOutside() const {
        const bool above = isAbove(Edge0) || isAbove(Edge1) || isAbove(Edge2);
        const bool below = isBelow(Edge0) || isBelow(Edge1) || isBelow(Edge2);
        return above && below;
    }
    bool isNotBetween() const {
        return (isAbove(AtReceiver) && isAbove(AtLight)) || (isBelow(AtReceiver) && isBelow(AtLight));
    }

    /// The caster's plane is as far from the receiver as the clearance: (n . (v - p))^2 = c^2 n . n, where c is linear.
    /// With E^2, of degree 12.
    void addClearance(std::vector<double>& cuts) const {
        const Polynomial& plane = functions_[AtReceiver].p;
        const Polynomial normals = dot(normal_, normal_);
        const std::vector<double> borders = way_.clearanceCuts();
        const Real most = way_.clearanceBetween(0.0, 1.0).largest();  // it is convex
        const Polynomial& sum = way_.sum();
        const Real limit = 2 * most * most * normals.greatest() * sum.largest() * sum.largest();
        const Polynomial square = plane * plane;
        if (square.least() > limit) return;
        for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
            if (!(borders[i] < borders[i + 1])) continue;
            // The linear function of this part, over all of [0, 1].
            const Polynomial here = way_.clearanceBetween(borders[i], borders[i + 1]);
            const Real slope = (here[1] - here[0]) / static_cast<Real>(borders[i + 1] - borders[i]);
            const Real open = here[0] - slope * static_cast<Real>(borders[i]);
            const Polynomial clearance{open, open + slope};
            const Polynomial reach = clearance * sum;
            const Polynomial difference = square - reach * reach * normals;
            std::vector<double> roots;
            addRoots(difference, 64 * epsilon * difference.largest(), roots);
            for (const double t : roots)
                if (t >= borders[i] && t <= borders[i + 1]) cuts.push_back(t);
            cuts.push_back(borders[i]);
        }
    }

    bool shadows(double t) const {
        const Receiver receiver = way_.receiverAt(t);
        // Whether it is tested changes at times of its own. Seen exactly edge-on it is no point.
        if (!(receiver.clearance > 0.0)) return false;
        const glm::dvec3 &from = receiver.answer.position, &to = receiver.light;
        glm::dvec3 vertices[3];
        way_.triangles().at(id_, way_.timeOf(t), vertices);
        return meet({from, to, 0.0, 1.0, glm::length(to - from), receiver.clearance}, vertices).hit;
    }

    const ReceiverWay& way_;
    std::uint32_t id_;
    VectorPolynomial v_[3], side_[3], normal_;
    Function functions_[functions];
};

/// The exposure of all spans, and of what of it no span of `without` covers. Both ascend; `without` may overlap.
struct Exposures {
    double all = 0.0, rest = 0.0;
};
Exposures exposuresOf(const FramePlan& plan, const ReceiverWay& way, const std::vector<TimeSpan>& spans,
                      const std::vector<TimeSpan>& without) {
    const auto between = [&](double t0, double t1) {
        return exposureUntil(plan, way.timeOf(t1)) - exposureUntil(plan, way.timeOf(t0));
    };
    Exposures sum;
    for (const TimeSpan& span : spans) {
        sum.all += between(span.begin, span.end);
        double reached = span.begin;
        for (const TimeSpan& dark : without) {
            if (dark.begin >= span.end) break;
            if (dark.begin > reached) sum.rest += between(reached, dark.begin);
            reached = std::max(reached, dark.end);
        }
        if (reached < span.end) sum.rest += between(reached, span.end);
    }
    return sum;
}

}  // namespace

LitSegment litSegment(const FramePlan& plan, const PositionRay& ray, const SeenSegment& segment,
                      const MovingTriangles& triangles, const SweptBvh& bvh) {
    LitSegment lit{segment};
    if (segment.triangle >= triangles.count()) return lit;
    const ReceiverWay way(plan, ray, segment, triangles);
    std::vector<double> cuts;
    way.addTestedChanges(cuts);
    std::vector<TimeSpan> tested, dark;
    forEachGap(cuts, [&](double t0, double t1, double middle) {
        if (way.receiverAt(middle).answer.tested) append(tested, t0, t1);
    });
    if (tested.empty()) return lit;
    // Far above what doubles round in boxes and coefficients, relative to the light and to all that casts shadows.
    const double pad = 1e-10 * (bvh.largestCoordinate() + glm::length(way.receiverAt(0.5).light));
    bvh.forEachUnless([&](const SweptBox& box) { return !way.mayShadow(box, pad); },
                      [&](std::uint32_t id) {
                          if (id != segment.triangle) CasterTimes(way, id).addTo(dark);
                      });
    std::sort(dark.begin(), dark.end(), [](const TimeSpan& a, const TimeSpan& b) { return a.begin < b.begin; });
    const Exposures exposures = exposuresOf(plan, way, tested, dark);
    lit.tested = exposures.all;
    lit.lit = exposures.rest;
    return lit;
}

}  // namespace timeshade::oracle
