#include "techniques/ranges/published_ranges_prediction.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace timeshade {

namespace {

using glm::dvec2;
using glm::dvec3;

/// A corner of the prism, or a point of its surface.
struct PrismPoint {
    dvec3 inMap;  ///< as in PathInMap
    double time;

    bool isCap() const { return std::min(time, 1.0 - time) < 1e-6; }
    double inverseDistance() const { return 1.0 / inMap.z; }  ///< NDC depth is linear in it
    dvec3 projected() const { return dvec3(dvec2(inMap), 1.0) / inMap.z; }
};

/// From what PrismPoint::projected returns.
dvec3 unprojected(const dvec3& place) { return dvec3(dvec2(place), 1.0) / place.z; }

double area(const dvec3& a, const dvec3& b) { return a.x * b.y - a.y * b.x; }

/// The points of a prism over one position of the map.
class PrismPoints {
  public:
    PrismPoints(const dvec2& position, double nearDistance) : position_(position), nearDistance_(nearDistance) {}

    void addFace(const PrismPoint& a, const PrismPoint& b, const PrismPoint& c) {
        const TriangleInMap face{{{a.inMap, a.inMap}, {b.inMap, b.inMap}, {c.inMap, c.inMap}}};
        const PlaneHit hit = hitOf(face, position_, 0.0);
        if (!hit.inside || hit.distance < nearDistance_) return;
        points_.push_back({dvec3(position_, 1.0) * hit.distance, glm::dot(hit.inSpace, dvec3(a.time, b.time, c.time))});
    }

    /// Two faces about the point where the edge ab crosses its moved copy dc in the map, else four about the centre.
    void addSide(const PrismPoint& a, const PrismPoint& b, const PrismPoint& c, const PrismPoint& d) {
        const bool inFront = std::min({a.inMap.z, b.inMap.z, c.inMap.z, d.inMap.z}) > 0.0;
        const dvec3 pa = a.projected(), pb = b.projected(), pc = c.projected(), pd = d.projected();
        const dvec3 ab = pb - pa, dc = pc - pd;
        const double whole = area(ab, dc), s = area(dc, pa - pd) / whole, t = area(ab, pa - pd) / whole;
        const bool parallel = std::abs(whole) <= 1e-5 * glm::length(dvec2(ab)) * glm::length(dvec2(dc));
        if (inFront && !parallel && s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) {
            const PrismPoint crossing{0.5 * (unprojected(pa + s * ab) + unprojected(pd + t * dc)), 0.5};
            addFace(a, d, crossing);
            addFace(b, c, crossing);
            return;
        }
        const PrismPoint centre{0.25 * (a.inMap + b.inMap + c.inMap + d.inMap), 0.5};
        addFace(a, b, centre);
        addFace(b, c, centre);
        addFace(c, d, centre);
        addFace(d, a, centre);
    }

    /// By depth; of equal depths (in floats, as a fragment has them) caps are first, then by time.
    std::vector<PrismPoint> sorted() {
        const auto key = [](const PrismPoint& p) {
            return std::tuple(-static_cast<float>(p.inverseDistance()), !p.isCap(), p.time);
        };
        std::sort(points_.begin(), points_.end(),
                  [&](const PrismPoint& a, const PrismPoint& b) { return key(a) < key(b); });
        return points_;
    }

  private:
    dvec2 position_;
    double nearDistance_;
    std::vector<PrismPoint> points_;
};

}  // namespace

std::optional<double> PublishedRangesPrediction::casterDistance(const ReceiverInMap& receiver, std::size_t caster,
                                                                const dvec2& position, double u, double) const {
    const PathInMap(&corners)[3] = receiver.triangles[caster].corners;
    if (caster == receiver.own) return std::nullopt;
    PrismPoint open[3], close[3];
    for (int i = 0; i < 3; ++i) {
        open[i] = {corners[i].open, 0.0};
        close[i] = {corners[i].close, 1.0};
    }
    PrismPoints prism(position, receiver.nearDistance);
    for (int i = 0; i < 3; ++i) prism.addSide(open[i], open[(i + 1) % 3], close[(i + 1) % 3], close[i]);
    prism.addFace(open[0], open[1], open[2]);
    prism.addFace(close[0], close[1], close[2]);
    const std::vector<PrismPoint> points = prism.sorted();
    double nearest = 0.0;
    for (std::size_t i = 0; i + 1 < std::min<std::size_t>(points.size(), 4); i += 2) {
        const auto& [begin, end] = std::minmax(
            points[i], points[i + 1], [](const PrismPoint& a, const PrismPoint& b) { return a.time < b.time; });
        if (u < begin.time || u > end.time) continue;
        const double length = end.time - begin.time, share = length > 0.0 ? (u - begin.time) / length : 0.0;
        nearest = std::max(nearest, glm::mix(begin.inverseDistance(), end.inverseDistance(), share));
    }
    return nearest > 0.0 ? std::optional(1.0 / nearest) : std::nullopt;
}

}  // namespace timeshade
