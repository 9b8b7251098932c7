#include <cmath>
#include <limits>
#include <tuple>

#include "oracle/implementation.h"
#include "oracle/oracle.h"
#include "oracle/parallel_rows.h"
#include "oracle/segment_triangle.h"

namespace timeshade {

using namespace oracle;

SeenByLight Oracle::seenByLight(const FramePlan& plan, const glm::dvec2& place, double u) const {
    const LightRay ray = lightRayThrough(plan, place, u);
    const SweptBvh& bvh = implementation_->bvh;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto nearest = static_cast<double>(plan.light.block.nearDistance);
    const Segment segment{ray.from, ray.from + ray.direction, nearest, infinity, infinity};
    const double reach = glm::length(ray.from) + bvh.largestCoordinate();
    const double pad = 4.0 * marginalShare * reach;
    const double farthest = 4.0 * (reach + pad) / glm::length(ray.direction);
    SeenByLight seen;
    seen.depth = infinity;
    bvh.forEachNear(ray.from, ray.direction, u, pad, farthest, [&](std::uint32_t id, double& limit) {
        glm::dvec3 v[3];
        implementation_->triangles.at(id, u, v);
        const Meeting meeting = meet(segment, v);
        if (meeting.hit && std::tuple(meeting.s, id) < std::tuple(seen.depth, seen.triangle) &&
            implementation_->cutouts.onLine(id, v, segment.from, segment.to, meeting.s).covers) {
            seen = {id, meeting.s};
            limit = std::min(limit, meeting.s + pad);  // another at the same depth is still visited
        }
        return true;
    });
    return seen;
}

std::vector<SeenByLight> Oracle::seenAlong(const FramePlan& plan, const MapLine& line, std::uint32_t columns,
                                           std::uint32_t rows) const {
    std::vector<SeenByLight> seen(std::size_t{columns} * rows);
    forEachPausing(rows, 4, [&](std::size_t row) {
        for (std::uint32_t column = 0; column < columns; ++column)
            seen[std::size_t{row} * columns + column] =
                seenByLight(plan, line.at((column + 0.5) / columns), (row + 0.5) / rows);
    });
    return seen;
}

glm::dvec3 Oracle::followed(std::uint32_t triangle, const glm::dvec3& position, double at, double u) const {
    const glm::dvec2 b = barycentricsOf(implementation_->triangles, triangle, position, at);
    glm::dvec3 v[3];
    implementation_->triangles.at(triangle, u, v);
    return v[0] + b.x * (v[1] - v[0]) + b.y * (v[2] - v[0]);
}

}  // namespace timeshade
