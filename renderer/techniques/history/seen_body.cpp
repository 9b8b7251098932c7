#include "techniques/history/seen_body.h"

#include <algorithm>
#include <array>

namespace timeshade {

namespace {

using Polygon = std::vector<glm::dvec3>;
using Plane = glm::dvec4;  ///< dot(plane, (p, 1)) >= 0 inside

double height(const Plane& plane, const glm::dvec3& p) { return glm::dot(plane, glm::dvec4(p, 1.0)); }

Polygon clipped(const Polygon& polygon, const Plane& plane) {
    Polygon out;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double ha = height(plane, a), hb = height(plane, b);
        if (ha >= 0.0) out.push_back(a);
        if ((ha >= 0.0) != (hb >= 0.0)) out.push_back(a + (b - a) * (ha / (ha - hb)));
    }
    return out;
}

struct Box {
    glm::dvec3 low{1e300}, high{-1e300};
};

Box boundsOf(const MeshTexels& texels) {
    Box box;
    for (const glm::vec3& vertex : texels.vertices) {
        box.low = glm::min(box.low, glm::dvec3(vertex));
        box.high = glm::max(box.high, glm::dvec3(vertex));
    }
    return box;
}

std::vector<Polygon> facesOf(const Box& box) {
    std::vector<Polygon> faces;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) {
            Polygon face;
            for (const auto& [a, b] : {std::array{0, 0}, std::array{1, 0}, std::array{1, 1}, std::array{0, 1}}) {
                glm::dvec3 p;
                p[axis] = upper ? box.high[axis] : box.low[axis];
                p[(axis + 1) % 3] = a != 0 ? box.high[(axis + 1) % 3] : box.low[(axis + 1) % 3];
                p[(axis + 2) % 3] = b != 0 ? box.high[(axis + 2) % 3] : box.low[(axis + 2) % 3];
                face.push_back(p);
            }
            faces.push_back(face);
        }
    return faces;
}

std::vector<Plane> planesOf(const Box& box) {
    std::vector<Plane> planes;
    for (int axis = 0; axis < 3; ++axis) {
        Plane low(0.0), high(0.0);
        low[axis] = 1.0;
        low.w = -box.low[axis];
        high[axis] = -1.0;
        high.w = box.high[axis];
        planes.push_back(low);
        planes.push_back(high);
    }
    return planes;
}

/// The four sides of the camera's pyramid, as triangles that reach `length` far, and their planes.
struct Pyramid {
    std::vector<Polygon> faces;
    std::vector<Plane> planes;
};

Pyramid pyramidOf(const ViewEnd& camera, double length) {
    const std::array<glm::dvec3, 4> rays{camera.corner, camera.corner + camera.right,
                                         camera.corner + camera.right + camera.up, camera.corner + camera.up};
    const glm::dvec3 middle = camera.corner + 0.5 * (camera.right + camera.up);
    Pyramid pyramid;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const glm::dvec3 &a = rays[i], &b = rays[(i + 1) % rays.size()];
        pyramid.faces.push_back({camera.eye, camera.eye + a * length, camera.eye + b * length});
        glm::dvec3 normal = glm::cross(a, b);
        if (glm::dot(normal, middle) < 0.0) normal = -normal;
        pyramid.planes.emplace_back(normal, -glm::dot(normal, camera.eye));
    }
    return pyramid;
}

/// The sides of what the light's map covers, and a plane just before the light.
std::vector<Plane> planesOf(const ViewPlan& light) {
    const glm::dmat4 rows = glm::transpose(glm::dmat4(light.block.viewFromWorldOpen));
    const Plane x = rows[0], y = rows[1], z = rows[2], one(0.0, 0.0, 0.0, 1.0);
    if (light.projection == Projection::Orthographic) return {x, y, one - x, one - y};
    return {z - one * static_cast<double>(light.block.nearDistance), x, y, z - x, z - y};
}

}  // namespace

std::vector<glm::dvec3> seenBody(const FramePlan& plan, const ViewEnd& camera) {
    const Box box = boundsOf(*plan.texels);
    const double length =
        4.0 * (glm::distance(box.low, box.high) + glm::distance(camera.eye, 0.5 * (box.low + box.high)));
    const Pyramid pyramid = pyramidOf(camera, length);
    std::vector<Polygon> surface;
    for (Polygon face : facesOf(box)) {
        for (const Plane& plane : pyramid.planes) face = clipped(face, plane);
        surface.push_back(std::move(face));
    }
    for (Polygon face : pyramid.faces) {
        for (const Plane& plane : planesOf(box)) face = clipped(face, plane);
        surface.push_back(std::move(face));
    }
    std::vector<glm::dvec3> corners;
    for (Polygon& face : surface) {
        for (const Plane& plane : planesOf(plan.light)) face = clipped(face, plane);
        corners.insert(corners.end(), face.begin(), face.end());
    }
    return corners;
}

glm::dvec2 onMapPlane(const ViewPlan& light, const glm::dvec3& point) {
    const glm::dvec3 v(glm::dmat4(light.block.viewFromWorldOpen) * glm::dvec4(point, 1.0));
    return light.projection == Projection::Orthographic ? glm::dvec2(v) : glm::dvec2(v) / v.z;
}

}  // namespace timeshade
