#include "oracle/segment_oracle.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "oracle/parallel_rows.h"
#include "oracle/seen_segments.h"
#include "oracle/segment_light.h"
#include "oracle/segment_triangle.h"

namespace timeshade {

using namespace oracle;

struct SegmentOracle::Implementation {
    explicit Implementation(const FramePlan& plan) : texels(plan.texels), triangles(texels->positions), bvh(triangles) {
        if (plan.cutouts)
            throw Error("a material of the scene is cut out by its alpha; what is seen when of such is not known");
    }

    std::shared_ptr<const MeshTexels> texels;
    MovingTriangles triangles;
    SweptBvh bvh;
};

namespace {

/// A triangle as a camera ray meets its plane.
struct PlaneMeeting {
    double depth = 0.0, depthSlack = 0.0;
    bool edgeOn = false;
};

PlaneMeeting meetPlane(const CameraRay& ray, const MovingTriangles& triangles, std::uint32_t id) {
    glm::dvec3 v[3];
    triangles.at(id, ray.time, v);
    const glm::dvec3 normal = glm::cross(v[1] - v[0], v[2] - v[0]);
    const double area = glm::length(normal), approach = std::abs(glm::dot(ray.direction, normal)),
                 length = glm::length(ray.direction);
    double longest = 0.0, farthest = glm::length(ray.eye);
    for (int i = 0; i < 3; ++i) {
        longest = std::max(longest, glm::length(v[(i + 1) % 3] - v[i]));
        farthest = std::max(farthest, glm::length(v[i] - ray.eye));
    }
    PlaneMeeting meeting;
    const double slack = marginalShare * (glm::length(ray.eye) + farthest);
    // How thick it looks from here, at least: its least height, slanted.
    meeting.edgeOn = !(area > 0.0) || approach / (length * longest) <= slack;
    if (approach == 0.0) return meeting;
    meeting.depth = glm::dot(v[0] - ray.eye, normal) / glm::dot(ray.direction, normal);
    meeting.depthSlack = slack * area / approach;
    return meeting;
}

}  // namespace

SegmentOracle::SegmentOracle(const FramePlan& plan) : implementation_(std::make_unique<Implementation>(plan)) {}
SegmentOracle::~SegmentOracle() = default;

std::vector<SeenSegment> SegmentOracle::seenBy(const FramePlan& plan, glm::vec2 place, glm::dvec2 aside) const {
    return seenSegments(positionRay(plan, place, aside), implementation_->triangles, implementation_->bvh);
}

std::vector<std::vector<SeenSegment>> SegmentOracle::seenByAll(const FramePlan& plan,
                                                               std::span<const glm::vec2> places) const {
    std::vector<std::vector<SeenSegment>> seen(places.size());
    forEachPausing(places.size(), 64, [&](std::size_t i) { seen[i] = seenBy(plan, places[i]); });
    return seen;
}

std::vector<LitSegment> SegmentOracle::litOver(const FramePlan& plan, glm::vec2 place,
                                               std::span<const SeenSegment> segments) const {
    const PositionRay ray = positionRay(plan, place, glm::dvec2(0.0));
    std::vector<LitSegment> lit;
    for (const SeenSegment& segment : segments)
        lit.push_back(litSegment(plan, ray, segment, implementation_->triangles, implementation_->bvh));
    return lit;
}

std::vector<std::vector<LitSegment>> SegmentOracle::litByAll(const FramePlan& plan,
                                                             std::span<const glm::vec2> places) const {
    std::vector<std::vector<LitSegment>> lit(places.size());
    forEachPausing(places.size(), 64,
                   [&](std::size_t i) { lit[i] = litOver(plan, places[i], seenBy(plan, places[i])); });
    return lit;
}

SegmentOracle::Doubt SegmentOracle::doubtBetween(const FramePlan& plan, glm::vec2 place, double u, std::uint32_t a,
                                                 std::uint32_t b) const {
    const PositionRay ends = positionRay(plan, place, glm::dvec2(0.0));
    const CameraRay ray = rayAt(ends, u);
    PlaneMeeting met[2];
    int count = 0;
    for (const std::uint32_t id : {a, b})
        if (id < implementation_->triangles.count()) met[count++] = meetPlane(ray, implementation_->triangles, id);
    for (int i = 0; i < count; ++i)
        if (met[i].edgeOn) return Doubt::EdgeOn;
    for (int i = 0; i < count; ++i)
        if (std::abs(met[i].depth - ends.nearDistance) <= met[i].depthSlack) return Doubt::DepthTie;
    if (count == 2 && std::abs(met[0].depth - met[1].depth) <= met[0].depthSlack + met[1].depthSlack)
        return Doubt::DepthTie;
    return Doubt::None;
}

}  // namespace timeshade
