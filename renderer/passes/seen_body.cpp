#include "passes/seen_body.h"

#include <algorithm>
#include <array>
#include <limits>

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

/// Half-spaces whose intersection is the points' convex hull, or slightly more. For a few points: tries all triples.
std::vector<Plane> hullOf(const std::vector<glm::dvec3>& points) {
    double size = 0.0;
    for (const glm::dvec3& p : points) size = std::max(size, glm::distance(p, points.front()));
    std::vector<Plane> planes;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j)
            for (std::size_t k = j + 1; k < points.size(); ++k) {
                const glm::dvec3 across = glm::cross(points[j] - points[i], points[k] - points[i]);
                if (glm::length(across) <= 1e-12 * size * size) continue;
                const glm::dvec3 normal = glm::normalize(across);
                double low = 1e300, high = -1e300;
                for (const glm::dvec3& p : points) {
                    low = std::min(low, glm::dot(normal, p - points[i]));
                    high = std::max(high, glm::dot(normal, p - points[i]));
                }
                // Set against the outermost point, so that no point is lost to rounding.
                const double offset = glm::dot(normal, points[i]);
                if (low >= -1e-9 * size) planes.emplace_back(normal, -offset - low);
                if (high <= 1e-9 * size) planes.emplace_back(-normal, offset + high);
            }
    return planes;
}

/// Corners of an intersection of half-spaces, each as often as faces meet in it. It lies within `reach` of `centre`.
std::vector<glm::dvec3> cornersOf(const std::vector<Plane>& planes, const glm::dvec3& centre, double reach) {
    std::vector<glm::dvec3> corners;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const glm::dvec3 normal = glm::normalize(glm::dvec3(planes[i]));
        const glm::dvec3 foot = centre - normal * (height(planes[i], centre) / glm::length(glm::dvec3(planes[i])));
        const glm::dvec3 other = std::abs(normal.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
        const glm::dvec3 a = 2.0 * reach * glm::normalize(glm::cross(normal, other)), b = glm::cross(normal, a);
        Polygon face{foot - a - b, foot + a - b, foot + a + b, foot - a + b};
        for (std::size_t k = 0; k < planes.size() && !face.empty(); ++k)
            if (k != i) face = clipped(face, planes[k]);
        corners.insert(corners.end(), face.begin(), face.end());
    }
    return corners;
}

/// The convex hull of points of a plane, in order around it, z = 0 (Andrew 1979).
Polygon outline(std::vector<glm::dvec2> points) {
    std::sort(points.begin(), points.end(),
              [](const glm::dvec2& a, const glm::dvec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<glm::dvec2> hull;
    for (const bool back : {false, true}) {
        const std::size_t begin = hull.size();
        for (const glm::dvec2& p : points) {
            while (hull.size() >= begin + 2) {
                const glm::dvec2 &a = hull[hull.size() - 2], &b = hull.back();
                if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0.0) break;
                hull.pop_back();
            }
            hull.push_back(p);
        }
        hull.pop_back();  // the first of the other side
        if (!back) std::reverse(points.begin(), points.end());
    }
    Polygon polygon;
    for (const glm::dvec2& p : hull) polygon.emplace_back(p, 0.0);
    return polygon;
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

std::vector<glm::dvec3> sweptSeenBody(const FramePlan& plan) {
    const Box box = boundsOf(*plan.texels);
    const glm::dvec3 centre = 0.5 * (box.low + box.high);
    const double diagonal = glm::distance(box.low, box.high);
    std::vector<glm::dvec3> pyramids;
    for (const ViewEnd* end : {&plan.camera.open, &plan.camera.close}) {
        const double length = 4.0 * (diagonal + glm::distance(end->eye, centre));
        pyramids.push_back(end->eye);
        for (const glm::dvec3& ray :
             {end->corner, end->corner + end->right, end->corner + end->right + end->up, end->corner + end->up})
            pyramids.push_back(end->eye + ray * length);
    }
    std::vector<Plane> planes = hullOf(pyramids);
    const auto add = [&](const std::vector<Plane>& more) { planes.insert(planes.end(), more.begin(), more.end()); };
    add(planesOf(box));
    if (!plan.motion.lightMoves) add(planesOf(plan.light));
    return cornersOf(planes, centre, diagonal);
}

double nearestSeen(const FramePlan& plan) {
    double nearest = std::numeric_limits<double>::infinity();
    const bool moves = plan.motion.cameraMoves || plan.motion.movingTriangles > 0;
    for (const bool closes : {false, true}) {
        if (closes && !moves) break;  // the same again
        const ViewEnd& camera = closes ? plan.camera.close : plan.camera.open;
        const std::vector<Plane> planes = pyramidOf(camera, 1.0).planes;
        const glm::dvec3 along = glm::normalize(camera.corner + 0.5 * (camera.right + camera.up));
        const auto position = [&](std::uint32_t vertex) {
            return glm::dvec3(plan.texels->vertices[2 * std::size_t{vertex} + (closes ? 1u : 0u)]);
        };
        for (const glm::u32vec3& t : plan.mesh->topology->triangles) {
            const std::array<glm::dvec3, 3> corners{position(t[0]), position(t[1]), position(t[2])};
            const auto isBeyond = [&](const Plane& plane) {
                return std::all_of(corners.begin(), corners.end(),
                                   [&](const glm::dvec3& corner) { return height(plane, corner) < 0.0; });
            };
            if (std::any_of(planes.begin(), planes.end(), isBeyond)) continue;
            Polygon seen(corners.begin(), corners.end());
            for (const Plane& plane : planes) seen = clipped(seen, plane);
            for (const glm::dvec3& p : seen) nearest = std::min(nearest, glm::dot(p - camera.eye, along));
        }
    }
    return nearest;
}

glm::dvec2 onMapPlane(const ViewPlan& light, const glm::dvec3& point) {
    const glm::dvec3 v(glm::dmat4(light.block.viewFromWorldOpen) * glm::dvec4(point, 1.0));
    return light.projection == Projection::Orthographic ? glm::dvec2(v) : glm::dvec2(v) / v.z;
}

std::vector<glm::dvec2> sweptOnMapPlane(const ViewPlan& light, const std::vector<glm::dvec3>& body) {
    std::vector<glm::dvec2> points;
    for (const glm::mat4* end : {&light.block.viewFromWorldOpen, &light.block.viewFromWorldClose})
        for (const glm::dvec3& corner : body) {
            const glm::dvec3 v(glm::dmat4(*end) * glm::dvec4(corner, 1.0));
            if (light.projection == Projection::Orthographic) {
                points.emplace_back(v);
            } else {
                if (!(v.z > static_cast<double>(light.block.nearDistance))) return {};
                points.push_back(glm::dvec2(v) / v.z);
            }
        }
    Polygon polygon = outline(std::move(points));
    for (const Plane& side : {Plane(1, 0, 0, 0), Plane(0, 1, 0, 0), Plane(-1, 0, 0, 1), Plane(0, -1, 0, 1)})
        polygon = clipped(polygon, side);
    std::vector<glm::dvec2> corners;
    for (const glm::dvec3& corner : polygon) corners.emplace_back(corner);
    return corners;
}

}  // namespace timeshade
