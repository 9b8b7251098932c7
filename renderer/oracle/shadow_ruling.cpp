#include "oracle/shadow_ruling.h"

namespace timeshade::oracle {

ShadowRuling ruleShadow(const SweptBvh& bvh, const MovingTriangles& triangles, const glm::dvec3& position, const glm::dvec3& light,
                        std::uint32_t receiver, double u) {
    const glm::dvec3 direction = light - position;
    const double length = glm::length(direction);
    const Segment segment{position, light, nearestCaster, 1.0, length};
    // Twice as far as a marginal triangle can be, plus what the boxes' own rounding may take away.
    const double pad = 2.0 * marginalShare * (glm::length(position) + length);
    ShadowRuling ruling;
    bvh.forEachNear(position, direction, u, pad, 1.0, [&](std::uint32_t id, double&) {
        if (id == receiver) return true;
        glm::dvec3 vertices[3];
        triangles.at(id, u, vertices);
        const Meeting meeting = meet(segment, vertices);
        ruling.lit = ruling.lit && !meeting.hit;
        ruling.marginal = ruling.marginal || meeting.marginal;
        const bool certain = meeting.hit && !meeting.marginal;
        if (certain) ruling.marginal = false;
        return !certain;
    });
    return ruling;
}

} // namespace timeshade::oracle
