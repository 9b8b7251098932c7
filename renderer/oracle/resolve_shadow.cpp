#include "oracle/resolve_shadow.h"

namespace timeshade::oracle {

ResolvedShadow resolveShadow(const SweptBvh& bvh, const MovingTriangles& triangles, const glm::dvec3& position,
                             const glm::dvec3& light, double clearance, std::uint32_t receiver, double u,
                             const CutoutCover* cutouts) {
    const glm::dvec3 direction = light - position;
    const double length = glm::length(direction);
    const Segment segment{position, light, 0.0, 1.0, length, clearance};
    // Twice as far as a marginal triangle can be, plus what the boxes' own rounding may take away.
    const double pad = 2.0 * marginalShare * (glm::length(position) + length);
    ResolvedShadow resolved;
    bvh.forEachNear(position, direction, u, pad, 1.0, [&](std::uint32_t id, double&) {
        if (id == receiver) return true;
        glm::dvec3 vertices[3];
        triangles.at(id, u, vertices);
        Meeting meeting = meet(segment, vertices);
        if (cutouts != nullptr && (meeting.hit || meeting.marginal) && cutouts->isCutOut(id)) {
            const CutoutCover::Cover cover = cutouts->onLine(id, vertices, position, light, meeting.s);
            if (!cover.covers && !cover.doubtful) return true;
            meeting.hit = meeting.hit && cover.covers;
            meeting.marginal = meeting.marginal || cover.doubtful;
        }
        resolved.lit = resolved.lit && !meeting.hit;
        resolved.marginal = resolved.marginal || meeting.marginal;
        const bool certain = meeting.hit && !meeting.marginal;
        if (certain) resolved.marginal = false;
        return !certain;
    });
    return resolved;
}

}  // namespace timeshade::oracle
