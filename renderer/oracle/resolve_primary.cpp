#include "oracle/resolve_primary.h"

#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace timeshade::oracle {

namespace {

/// A triangle that the ray meets, or might for all that a float can tell.
struct Candidate {
    std::uint32_t triangle;
    double depth;
    double slack;  ///< how far a float's rounding may move the depth
    bool seen;     ///< met, and not from behind unless two-sided
    bool marginal;
};

double depthSlack(const CameraRay& ray, const glm::dvec3 (&v)[3], double depth) {
    const glm::dvec3 normal = glm::cross(v[1] - v[0], v[2] - v[0]);
    const double approach = std::abs(glm::dot(ray.direction, normal));
    const double scale = glm::length(ray.eye) + std::abs(depth) * glm::length(ray.direction);
    return approach > 0.0 ? marginalShare * scale * glm::length(normal) / approach : HUGE_VAL;
}

}  // namespace

Oracle::ResolvedPrimary resolveFirstSeen(const SweptBvh& bvh, const MovingTriangles& triangles, const CameraRay& ray,
                                         double nearDistance, const CutoutCover* cutouts) {
    const double infinity = std::numeric_limits<double>::infinity();
    const Segment segment{ray.eye, ray.eye + ray.direction, nearDistance, infinity, infinity};
    const double pad = 4.0 * marginalShare * (glm::length(ray.eye) + bvh.largestCoordinate());
    std::vector<Candidate> candidates;
    // Past all triangles, whatever the length of the direction.
    const double farthest = 4.0 * (glm::length(ray.eye) + bvh.largestCoordinate() + pad) / glm::length(ray.direction);
    bvh.forEachNear(ray.eye, ray.direction, ray.time, pad, farthest, [&](std::uint32_t id, double& limit) {
        glm::dvec3 v[3];
        triangles.at(id, ray.time, v);
        const Meeting meeting = meet(segment, v);
        if (!meeting.hit && !meeting.marginal) return true;
        const bool culled = meeting.facing < 0 && !triangles.doubleSided(id);
        if (culled && meeting.hit && !meeting.facingMarginal) return true;
        CutoutCover::Cover cover;
        if (cutouts != nullptr) cover = cutouts->onLine(id, v, segment.from, segment.to, meeting.s);
        if (!cover.covers && !cover.doubtful) return true;
        const Candidate candidate{
            id, meeting.s, depthSlack(ray, v, meeting.s), meeting.hit && !culled && cover.covers,
            meeting.marginal || cover.doubtful || (meeting.facingMarginal && !triangles.doubleSided(id))};
        candidates.push_back(candidate);
        // What lies clearly behind a triangle that is clearly seen does not matter.
        if (candidate.seen && !candidate.marginal) limit = std::min(limit, candidate.depth + 2.0 * candidate.slack);
        return true;
    });

    const Candidate* first = nullptr;
    for (const Candidate& c : candidates)
        if (c.seen && (!first || std::tuple(c.depth, c.triangle) < std::tuple(first->depth, first->triangle)))
            first = &c;
    Oracle::ResolvedPrimary resolved;
    if (first) resolved = {first->triangle, first->marginal};
    for (const Candidate& c : candidates)
        if (&c != first && (!first || c.depth - c.slack <= first->depth + first->slack)) resolved.marginal = true;
    return resolved;
}

}  // namespace timeshade::oracle
