#include "oracle/camera_rays.h"

#include <algorithm>
#include <cmath>

#include "shared/sample_pattern.shared.h"

namespace timeshade::oracle {

namespace {

glm::dvec3 between(const glm::dvec3& open, const glm::dvec3& close, double u) { return open * (1.0 - u) + close * u; }

/// A bound on how far floats move a receiver on this triangle: 2^-21 of its largest coordinate (docs/numerics.md,
/// "Definition of shadow").
double clearanceOf(const glm::dvec3 (&v)[3]) {
    double largest = 0.0;
    for (const glm::dvec3& vertex : v)
        largest = std::max({largest, std::abs(vertex.x), std::abs(vertex.y), std::abs(vertex.z)});
    return std::ldexp(largest, -21);
}

/// Against a spot's axis at time u.
glm::dvec3 spotBack(const FramePlan& plan, double u) {
    if (plan.lightOpen.axes[2] == plan.lightClose.axes[2]) return plan.lightOpen.axes[2];
    return glm::normalize(between(plan.lightOpen.axes[2], plan.lightClose.axes[2], u));
}

/// Facing and cone, as design section 1 and `facesLight` of the shaders define them.
void testLight(const FramePlan& plan, const glm::dvec3& normal, Receiver& receiver) {
    OracleAnswer& answer = receiver.answer;
    const glm::dvec3 l = receiver.light - answer.position;
    const double scale = glm::length(answer.position) + glm::length(l);
    const double facing = glm::dot(normal, l);
    answer.marginal = std::abs(facing) <= marginalShare * scale * glm::length(normal);
    answer.tested = facing > 0.0;
    if (plan.lightOpen.kind == LightKind::Directional) return;
    const glm::dvec3 back = spotBack(plan, static_cast<double>(answer.time));
    const double along = glm::dot(l, back);  // the light looks along -back
    const double inside = along - std::cos(plan.lightOpen.outerConeAngle) * glm::length(l);
    answer.marginal = answer.marginal || std::abs(inside) <= marginalShare * scale;
    answer.tested = answer.tested && inside >= 0.0;
}

}  // namespace

CameraRay cameraRay(const FramePlan& plan, SampleIndex sample) {
    const glm::uvec2 pixel(sample.x, sample.y);
    const shared::FrameBlock& block = plan.block;
    const glm::vec3 pattern =
        shared::cameraSample(pixel, block.firstStratum + sample.stratum, block.seed, block.pixelCentres);
    const float u = shared::sampleTime(block.timeBase, block.timeScale, sample.stratum, pattern.z);
    return cameraRayThrough(plan, glm::vec2(pixel) + glm::vec2(pattern), u);
}

CameraRay cameraRayThrough(const FramePlan& plan, glm::vec2 place, float u) {
    const glm::dvec2 position(place / plan.camera.block.size);
    const ViewEnd &open = plan.camera.open, &close = plan.camera.close;
    CameraRay ray;
    ray.time = static_cast<double>(u);
    ray.eye = between(open.eye, close.eye, ray.time);
    ray.direction = between(open.corner + position.x * open.right + position.y * open.up,
                            close.corner + position.x * close.right + position.y * close.up, ray.time);
    return ray;
}

glm::dvec3 lightEnd(const FramePlan& plan, const glm::dvec3& position, double u) {
    if (plan.lightOpen.kind == LightKind::Directional) {
        // Its component along the mean direction is the same at every time: the length that the map's depth needs.
        const glm::dvec3& mean = plan.lightAxes[2];
        const glm::dvec3 back = between(plan.lightOpen.axes[2] / glm::dot(plan.lightOpen.axes[2], mean),
                                        plan.lightClose.axes[2] / glm::dot(plan.lightClose.axes[2], mean), u);
        return position + static_cast<double>(plan.light.block.farDistance) * back;
    }
    return between(plan.lightOpen.position - plan.origin, plan.lightClose.position - plan.origin, u);
}

Receiver receiverOf(const FramePlan& plan, const MovingTriangles& triangles, SampleIndex sample,
                    std::uint32_t triangle) {
    return receiverOf(plan, triangles, cameraRay(plan, sample), triangle);
}

Receiver receiverOf(const FramePlan& plan, const MovingTriangles& triangles, const CameraRay& ray,
                    std::uint32_t triangle) {
    Receiver receiver;
    receiver.answer.time = static_cast<float>(ray.time);
    if (triangle >= triangles.count()) return receiver;
    glm::dvec3 v[3];
    triangles.at(triangle, ray.time, v);
    glm::dvec3 normal = glm::cross(v[1] - v[0], v[2] - v[0]);
    const double approach = glm::dot(ray.direction, normal);
    receiver.answer.hit = true;
    if (approach == 0.0) {
        // Only rounding can make a camera see a triangle edge-on; there is no one point that it sees.
        receiver.answer.position = v[0];
        receiver.answer.marginal = true;
        return receiver;
    }
    receiver.answer.position = ray.eye + ray.direction * (glm::dot(v[0] - ray.eye, normal) / approach);
    if (approach > 0.0 && triangles.doubleSided(triangle)) normal = -normal;
    receiver.light = lightEnd(plan, receiver.answer.position, ray.time);
    receiver.clearance = clearanceOf(v);
    testLight(plan, normal, receiver);
    return receiver;
}

glm::dvec2 barycentricsOf(const MovingTriangles& triangles, std::uint32_t triangle, const glm::dvec3& position,
                          double u) {
    glm::dvec3 v[3];
    triangles.at(triangle, u, v);
    const glm::dvec3 a = v[1] - v[0], b = v[2] - v[0], p = position - v[0], normal = glm::cross(a, b);
    return glm::dvec2(glm::dot(glm::cross(p, b), normal), glm::dot(glm::cross(a, p), normal)) /
           glm::dot(normal, normal);
}

Receiver receiverOnTriangle(const FramePlan& plan, const MovingTriangles& triangles, std::uint32_t triangle,
                            glm::dvec2 barycentrics, float u) {
    Receiver receiver;
    receiver.answer.time = u;
    const double time = static_cast<double>(u);
    glm::dvec3 v[3];
    triangles.at(triangle, time, v);
    receiver.answer.hit = true;
    receiver.answer.position = v[0] + barycentrics.x * (v[1] - v[0]) + barycentrics.y * (v[2] - v[0]);
    glm::dvec3 normal = glm::cross(v[1] - v[0], v[2] - v[0]);
    const glm::dvec3 eye = between(plan.camera.open.eye, plan.camera.close.eye, time);
    if (triangles.doubleSided(triangle) && glm::dot(v[0] - eye, normal) > 0.0) normal = -normal;
    receiver.light = lightEnd(plan, receiver.answer.position, time);
    receiver.clearance = clearanceOf(v);
    testLight(plan, normal, receiver);
    return receiver;
}

}  // namespace timeshade::oracle
