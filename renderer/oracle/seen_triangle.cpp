#include "oracle/seen_triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace timeshade::oracle {

namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
// Coefficients with a larger share of error than this are computed again, exactly.
const Real vagueShare = std::ldexp(static_cast<Real>(1), -40);

using RealVector = glm::tvec3<Real>;

VectorPolynomial wayBetween(const glm::dvec3 (&from)[2], const glm::dvec3 (&to)[2]) {
    return VectorPolynomial::between(RealVector(to[0]) - RealVector(from[0]), RealVector(to[1]) - RealVector(from[1]));
}

}  // namespace

std::optional<double> timeBetween(double a, double b) {
    const double middle = 0.5 * (a + b), quarter = 0.25 * (b - a);
    for (double unit = 0.5; unit >= 0x1p-60; unit *= 0.5) {
        const double time = std::nearbyint(middle / unit) * unit;
        if (std::abs(time - middle) < quarter) return time;
    }
    if (a < middle && middle < b) return middle;
    return std::nullopt;
}

SeenTriangle::SeenTriangle(const PositionRay& ray, const MovingTriangles& triangles, std::uint32_t id)
    : ray_(ray), id_(id), twoSided_(triangles.doubleSided(id)) {
    for (int v = 0; v < 3; ++v)
        for (int end = 0; end < 2; ++end) vertices_[v][end] = triangles.end(id, v, end == 1);
    if (!makeFunctions()) return;
    for (int which = 0; which < functionCount; ++which)
        if (isVague(functions_[which])) functions_[which] = rounded(exact(static_cast<Which>(which)));
    makeSpans();
}

/// Error bounds count some 20 roundings of products whose factors are bounded by the vectors' largest components; four
/// times as many are allowed for.
bool SeenTriangle::makeFunctions() {
    VectorPolynomial w[3], side[3];
    for (int i = 0; i < 3; ++i) w[i] = wayBetween(ray_.eye, vertices_[i]);
    for (int i = 0; i < 3; ++i) side[i] = wayBetween(vertices_[(i + 1) % 3], vertices_[(i + 2) % 3]);
    const VectorPolynomial d = VectorPolynomial::between(RealVector(ray_.direction[0]), RealVector(ray_.direction[1]));
    const Real dSize = d.largest();
    for (int i = 0; i < 3; ++i) {
        // (a + b) x (b - a) is 2 a x b, without the cancellation where a and b are close to each other; exactly
        // opposite for the neighbour at the edge.
        const VectorPolynomial &a = w[(i + 1) % 3], &b = w[(i + 2) % 3];
        functions_[i] = {dot(d, cross(a + b, side[i])),
                         128 * epsilon * dSize * ((a.largest() + b.largest()) * side[i].largest())};
        functions_[i].p = static_cast<Real>(0.5) * functions_[i].p;
    }
    if (isNeverSeen({Edge0, Edge1, Edge2})) return false;
    const VectorPolynomial normal = cross(side[2], static_cast<Real>(-1) * Polynomial{1} * side[1]);
    const Real area = side[1].largest() * side[2].largest();
    functions_[Sum] = {dot(d, normal), 128 * epsilon * dSize * area};
    functions_[Plane] = {dot(w[0], normal), 128 * epsilon * w[0].largest() * area};
    const auto nearDistance = static_cast<Real>(ray_.nearDistance);
    functions_[Near] = {functions_[Plane].p - nearDistance * functions_[Sum].p,
                        2 * (functions_[Plane].error + nearDistance * functions_[Sum].error)};
    return !isNeverSeen({Edge0, Edge1, Edge2, Near});
}

/// From the front all of these are negative, from behind positive.
bool SeenTriangle::isNeverSeen(std::initializer_list<Which> all) const {
    bool front = true, back = twoSided_;
    for (const Which which : all) {
        const Function& f = functions_[which];
        front = front && f.p.least() <= f.error;
        back = back && f.p.greatest() >= -f.error;
    }
    return !front && !back;
}

void SeenTriangle::makeSpans() {
    std::vector<double> cuts{0.0, 1.0};
    for (const Which which : {Edge0, Edge1, Edge2, Near})
        addRoots(functions_[which].p, std::max(functions_[which].error, 16 * epsilon * functions_[which].p.largest()),
                 cuts);
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const std::optional<double> middle = timeBetween(cuts[i], cuts[i + 1]);
        if (!middle || !seenAt(*middle)) continue;
        if (!spans_.empty() && spans_.back().end == cuts[i])
            spans_.back().end = cuts[i + 1];
        else
            spans_.push_back({cuts[i], cuts[i + 1]});
    }
}

bool SeenTriangle::seenAt(double u) const {
    bool positive = false, negative = false;
    for (const Which which : {Edge0, Edge1, Edge2}) {
        const int sign = signAt(which, u);
        positive = positive || sign > 0;
        negative = negative || sign < 0;
        if (positive && (negative || !twoSided_)) return false;
    }
    if (!positive && !negative) return false;
    return signAt(Near, u) == (positive ? 1 : -1);
}

bool SeenTriangle::isBefore(const SeenTriangle& other, double u) const {
    const std::optional<int> quick = signOf(orderTo(other), u);
    int order = quick ? *quick : exactOrderTo(other).signAt(u);
    order *= signAt(Sum, u) * other.signAt(Sum, u);
    return order < 0 || (order == 0 && id_ < other.id_);
}

void SeenTriangle::addOrderChanges(const SeenTriangle& other, std::vector<double>& times) const {
    Function order = orderTo(other);
    if (order.p.least() > order.error || order.p.greatest() < -order.error) return;
    if (isVague(order)) order = rounded(exactOrderTo(other));
    addRoots(order.p, std::max(order.error, 32 * epsilon * order.p.largest()), times);
}

SeenTriangle::Function SeenTriangle::orderTo(const SeenTriangle& other) const {
    const Function &sum = functions_[Sum], &plane = functions_[Plane];
    const Function &otherSum = other.functions_[Sum], &otherPlane = other.functions_[Plane];
    const auto product = [](const Function& a, const Function& b) {
        const Real aSize = a.p.largest(), bSize = b.p.largest();
        return Function{a.p * b.p, a.error * (bSize + b.error) + aSize * b.error + 64 * epsilon * aSize * bSize};
    };
    const Function first = product(plane, otherSum), second = product(otherPlane, sum);
    return {first.p - second.p, first.error + second.error};
}

ExactPolynomial SeenTriangle::exactOrderTo(const SeenTriangle& other) const {
    return exact(Plane) * other.exact(Sum) - other.exact(Plane) * exact(Sum);
}

ExactPolynomial SeenTriangle::exact(Which which) const {
    const ExactWay w[3] = {ExactWay::difference(vertices_[0], ray_.eye), ExactWay::difference(vertices_[1], ray_.eye),
                           ExactWay::difference(vertices_[2], ray_.eye)};
    const ExactWay d = ExactWay::of(ray_.direction);
    const auto edge = [&](int i) { return determinant(d, w[(i + 1) % 3], w[(i + 2) % 3]); };
    const auto sum = [&] { return edge(0) + edge(1) + edge(2); };
    const auto plane = [&] { return determinant(w[0], w[1], w[2]); };
    if (which == Sum) return sum();
    if (which == Plane) return plane();
    if (which == Near) return plane() - sum() * ray_.nearDistance;
    return edge(which);
}

int SeenTriangle::signAt(Which which, double u) const {
    const std::optional<int> quick = signOf(functions_[which], u);
    return quick ? *quick : exact(which).signAt(u);
}

std::optional<int> SeenTriangle::signOf(const Function& f, double u) {
    const Real value = f.p.at(static_cast<Real>(u));
    if (std::abs(value) <= f.error + 64 * epsilon * f.p.largest()) return std::nullopt;
    return value > 0 ? 1 : -1;
}

bool SeenTriangle::isVague(const Function& f) { return f.error > vagueShare * f.p.largest(); }

SeenTriangle::Function SeenTriangle::rounded(const ExactPolynomial& exact) {
    const Polynomial p = exact.rounded();
    return {p, static_cast<Real>(2 * std::numeric_limits<double>::epsilon()) * p.largest()};
}

}  // namespace timeshade::oracle
