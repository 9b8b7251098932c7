#include "culling/closed_surfaces.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/check.h"
#include "culling/self_crossing.h"

namespace timeshade {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

std::vector<std::uint32_t> instancesOfVertices(const MeshTopology& topology) {
    std::vector<std::uint32_t> instances(topology.vertexCount, none);
    for (std::size_t i = 0; i < topology.triangles.size(); ++i)
        for (int corner = 0; corner < 3; ++corner)
            instances[topology.triangles[i][corner]] = topology.triangleInstances[i];
    return instances;
}

/// For every vertex, the first one of its instance with the same position.
std::vector<std::uint32_t> weld(const MotionMesh& mesh) {
    const std::vector<std::uint32_t> instances = instancesOfVertices(*mesh.topology);
    const auto key = [&](std::uint32_t v) {
        const glm::dvec3& p = mesh.positionsOpen[v];
        return std::tuple(instances[v], p.x, p.y, p.z);
    };
    std::vector<std::uint32_t> order(mesh.topology->vertexCount);
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
    std::vector<std::uint32_t> same(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        same[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? same[order[i - 1]] : order[i];
    return same;
}

/// Disjoint sets (union-find); each is represented by its smallest member.
class Sets {
  public:
    explicit Sets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0u); }
    std::uint32_t of(std::uint32_t member) {
        while (parents_[member] != member) member = parents_[member] = parents_[parents_[member]];
        return member;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = of(a);
        b = of(b);
        parents_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parents_;
};

/// An edge of a triangle, and whether the triangle uses it from low to high (1) or from high to low (-1).
struct Edge {
    std::uint32_t low, high, triangle;
    int sense;
};

/// Sets of triangles connected by edges.
struct Connected {
    Sets sets;                    ///< of triangles
    std::vector<char> open;       ///< by set: some edge is used more often in one direction than in the other
    std::vector<char> branching;  ///< by set: some edge belongs to more than two triangles
};

Connected connect(const std::vector<glm::u32vec3>& triangles) {
    std::vector<Edge> edges;
    edges.reserve(3 * triangles.size());
    for (std::uint32_t id = 0; id < triangles.size(); ++id) {
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t from = triangles[id][corner], to = triangles[id][(corner + 1) % 3];
            if (from != to) edges.push_back({std::min(from, to), std::max(from, to), id, from < to ? 1 : -1});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    Connected connected{Sets(triangles.size()), std::vector<char>(triangles.size()),
                        std::vector<char>(triangles.size())};
    std::vector<std::uint32_t> uneven, branching;
    for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
        int sum = 0;
        for (end = first;
             end < edges.size() && edges[end].low == edges[first].low && edges[end].high == edges[first].high; ++end) {
            sum += edges[end].sense;
            connected.sets.join(edges[first].triangle, edges[end].triangle);
        }
        if (sum != 0) uneven.push_back(edges[first].triangle);
        if (end - first > 2) branching.push_back(edges[first].triangle);
    }
    for (const std::uint32_t triangle : uneven) connected.open[connected.sets.of(triangle)] = 1;
    for (const std::uint32_t triangle : branching) connected.branching[connected.sets.of(triangle)] = 1;
    return connected;
}

/// Four vertices far apart from one another, ordered so that their tetrahedron has a positive volume.
std::array<std::uint32_t, 4> farApart(const std::vector<std::uint32_t>& vertices,
                                      const std::vector<glm::dvec3>& positions) {
    std::array<std::uint32_t, 4> corners{};
    corners.fill(vertices.front());
    const auto place = [&](int i) { return positions[corners[static_cast<std::size_t>(i)]]; };
    const auto farthest = [&](auto&& measure) {
        return *std::max_element(vertices.begin(), vertices.end(),
                                 [&](auto a, auto b) { return measure(positions[a]) < measure(positions[b]); });
    };
    corners[1] = farthest([&](const glm::dvec3& p) { return glm::length(p - place(0)); });
    corners[2] =
        farthest([&](const glm::dvec3& p) { return glm::length(glm::cross(p - place(0), place(1) - place(0))); });
    const glm::dvec3 normal = glm::cross(place(1) - place(0), place(2) - place(0));
    corners[3] = farthest([&](const glm::dvec3& p) { return std::abs(glm::dot(p - place(0), normal)); });
    if (glm::dot(place(3) - place(0), normal) < 0.0) std::swap(corners[1], corners[2]);
    return corners;
}

double volume(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) { return glm::dot(a, glm::cross(b, c)); }

/// Whether the tetrahedron's volume, a cubic in u, is positive during the whole shutter, by its Bernstein coefficients.
bool isNeverMirrored(const MotionMesh& mesh, const std::array<std::uint32_t, 4>& corners) {
    glm::dvec3 a[3], b[3];
    for (std::size_t i = 0; i < 3; ++i) {
        a[i] = mesh.positionsOpen[corners[i + 1]] - mesh.positionsOpen[corners[0]];
        b[i] = mesh.positionsClose[corners[i + 1]] - mesh.positionsClose[corners[0]];
    }
    return volume(a[0], a[1], a[2]) > 0.0 &&
           volume(b[0], a[1], a[2]) + volume(a[0], b[1], a[2]) + volume(a[0], a[1], b[2]) > 0.0 &&
           volume(a[0], b[1], b[2]) + volume(b[0], a[1], b[2]) + volume(b[0], b[1], a[2]) > 0.0 &&
           volume(b[0], b[1], b[2]) > 0.0;
}

/// Whether the surface bounds a solid with front faces outside. `triangles`: of the surface, with merged vertices, two
/// triangles at each edge.
bool boundsASolid(const std::vector<glm::dvec3>& positions, const std::vector<glm::u32vec3>& triangles) {
    const glm::dvec3 centre = positions[triangles.front().x];  // any point works; a near one keeps precision
    double enclosed = 0.0;
    for (const glm::u32vec3& t : triangles)
        enclosed += volume(positions[t.x] - centre, positions[t.y] - centre, positions[t.z] - centre);
    return enclosed > 0.0 && !mayCrossItself(positions, triangles);
}

/// The depth along the view's axis as a linear function of the position relative to the eye.
glm::dvec3 depthAxis(const ViewEnd& end) {
    const glm::dvec3 normal = glm::cross(end.right, end.up);
    return normal / glm::dot(normal, end.corner);
}

/// The distance from the eye to the near plane's farthest corner.
double nearPlaneReach(const ViewPlan& view) {
    double farthest = 0.0;
    for (const ViewEnd* end : {&view.open, &view.close})
        for (const double s : {0.0, 1.0})
            for (const double t : {0.0, 1.0})
                farthest = std::max(farthest, glm::length(end->corner + s * end->right + t * end->up));
    return farthest * static_cast<double>(view.block.nearDistance);
}

}  // namespace

ClosedSurfaces::ClosedSurfaces(const MotionMesh& mesh, const std::vector<Material>& materials) {
    const MeshTopology& topology = *mesh.topology;
    const std::vector<std::uint32_t> same = weld(mesh);
    std::vector<glm::u32vec3> triangles;
    for (const glm::u32vec3& t : topology.triangles) triangles.emplace_back(same[t.x], same[t.y], same[t.z]);
    Connected connected = connect(triangles);

    std::vector<std::vector<std::uint32_t>> sets(triangles.size());
    for (std::uint32_t id = 0; id < triangles.size(); ++id) sets[connected.sets.of(id)].push_back(id);
    ofTriangles_.assign(triangles.size(), 0);
    for (std::size_t set = 0; set < sets.size(); ++set) {
        const std::vector<std::uint32_t>& ids = sets[set];
        if (ids.size() < 4 || connected.open[set]) continue;
        Surface surface;
        std::vector<glm::u32vec3> own;
        for (const std::uint32_t id : ids) {
            const glm::u32vec3& t = triangles[id];
            if (t.x != t.y && t.y != t.z && t.z != t.x) own.push_back(t);
            for (int corner = 0; corner < 3; ++corner) surface.vertices.push_back(topology.triangles[id][corner]);
        }
        surface.nowhereNegative = !connected.branching[set] && !own.empty() && boundsASolid(mesh.positionsOpen, own);
        // What is cut out is not closed.
        const bool isOpen = std::any_of(ids.begin(), ids.end(), [&](std::uint32_t id) {
            return materials[topology.triangleMaterials[id]].cutout.has_value();
        });
        const bool twoSided = std::all_of(ids.begin(), ids.end(), [&](std::uint32_t id) {
            return materials[topology.triangleMaterials[id]].doubleSided;
        });
        if (isOpen || (!surface.nowhereNegative && !twoSided)) continue;
        std::sort(surface.vertices.begin(), surface.vertices.end());
        surface.vertices.erase(std::unique(surface.vertices.begin(), surface.vertices.end()), surface.vertices.end());
        surface.corners = farApart(surface.vertices, mesh.positionsOpen);
        surfaces_.push_back(std::move(surface));
        for (const std::uint32_t id : ids) ofTriangles_[id] = static_cast<std::uint32_t>(surfaces_.size());
    }
    for (std::uint32_t surface = 1; surface <= surfaces_.size(); ++surface)
        for (const std::uint32_t v : surfaces_[surface - 1].vertices)
            if (same[v] != v) seams_.push_back({v, same[v], surface});
}

std::vector<char> ClosedSurfaces::facingAwayCullable(const MotionMesh& mesh, const glm::dvec3& origin,
                                                     const ViewPlan& camera, const ViewPlan& light) const {
    CHECK_EQ(mesh.topology->triangles.size(), ofTriangles_.size());
    // Much larger than the rounding of views and positions, much smaller than anything visible.
    constexpr double slack = 1e-5;
    const glm::dvec3 eyes[2] = {camera.open.eye + origin, camera.close.eye + origin};
    const double reach = nearPlaneReach(camera);
    // The shadow map of a directional light contains the scene, so it has no near plane to check.
    const bool spot = light.projection == Projection::Perspective;
    const glm::dvec3 lights[2] = {light.open.eye + origin, light.close.eye + origin};
    const glm::dvec3 axis = spot ? depthAxis(light.open) : glm::dvec3(0.0);

    std::vector<char> cullable(surfaces_.size() + 1, 0);
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        const Surface& surface = surfaces_[i];
        if (surface.nowhereNegative && !isNeverMirrored(mesh, surface.corners)) continue;
        // Relative to the eye at both ends; linear paths between them stay inside these bounds.
        glm::dvec3 low(1e300), high(-1e300);
        double nearest = 1e300, farthest = 0.0;
        for (const std::uint32_t v : surface.vertices) {
            const glm::dvec3 places[2] = {mesh.positionsOpen[v], mesh.positionsClose[v]};
            for (int end = 0; end < 2; ++end) {
                low = glm::min(low, places[end] - eyes[end]);
                high = glm::max(high, places[end] - eyes[end]);
                const double depth = glm::dot(axis, places[end] - lights[end]);
                nearest = std::min(nearest, depth);
                farthest = std::max(farthest, depth);
            }
        }
        const double margin = reach + slack * std::max({high.x, high.y, high.z, -low.x, -low.y, -low.z});
        const bool eyeOutside = surface.nowhereNegative || glm::any(glm::greaterThan(low, glm::dvec3(margin))) ||
                                glm::any(glm::lessThan(high, glm::dvec3(-margin)));
        const bool lightOutside = !spot || nearest > static_cast<double>(light.block.nearDistance) + slack * farthest;
        cullable[i + 1] = eyeOutside && lightOutside ? 1 : 0;
    }
    for (const Seam& seam : seams_)
        if (mesh.positionsOpen[seam.vertex] != mesh.positionsOpen[seam.same] ||
            mesh.positionsClose[seam.vertex] != mesh.positionsClose[seam.same])
            cullable[seam.surface] = 0;
    return cullable;
}

}  // namespace timeshade
