#include "scene/edge_split.h"

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>

namespace timeshade {

namespace {

using Place = std::array<double, 3>;
Place placeOf(const glm::dvec3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

/// One number for all vertices at a place, and whether their normals differ there.
struct Places {
    std::vector<std::uint32_t> ofVertex;
    std::vector<char> sharp;  ///< of each place

    explicit Places(const MotionMesh& mesh) : ofVertex(mesh.positionsOpen.size()) {
        std::map<Place, std::uint32_t> known;
        std::vector<std::uint32_t> first;
        for (std::uint32_t v = 0; v < ofVertex.size(); ++v) {
            const auto number = static_cast<std::uint32_t>(first.size());
            const auto [found, isNew] = known.try_emplace(placeOf(mesh.positionsOpen[v]), number);
            ofVertex[v] = found->second;
            if (isNew) {
                first.push_back(v);
                sharp.push_back(0);
            } else if (glm::dot(mesh.normalsOpen[v], mesh.normalsOpen[first[found->second]]) < 0.999999f) {
                sharp[found->second] = 1;
            }
        }
    }
};

glm::dvec3 onCurve(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& normalA, const glm::dvec3& normalB) {
    const glm::dvec3 way = b - a;
    // The middle of a cubic whose tangents at both ends are perpendicular to the normals there.
    return 0.5 * (a + b) + 0.125 * (glm::dot(way, normalB) * normalB - glm::dot(way, normalA) * normalA);
}

/// The corners of a triangle and of what lies on its sides: from corner i to the next.
std::vector<glm::u32vec3> between(const glm::u32vec3& corners, const std::array<std::optional<std::uint32_t>, 3>& on) {
    const auto parts = std::count_if(on.begin(), on.end(), [](const auto& middle) { return middle.has_value(); });
    if (parts == 0) return {corners};
    if (parts == 3)
        return {{corners.x, *on[0], *on[2]},
                {*on[0], corners.y, *on[1]},
                {*on[2], *on[1], corners.z},
                {*on[0], *on[1], *on[2]}};
    // Turned until the undivided side, or the only divided one, is the last one, or the first.
    for (int turn = 0; turn < 3; ++turn) {
        const auto at = [turn](int i) { return (i + turn) % 3; };
        const auto &first = on[static_cast<std::size_t>(at(0))], &second = on[static_cast<std::size_t>(at(1))];
        const std::uint32_t a = corners[at(0)], b = corners[at(1)], c = corners[at(2)];
        if (parts == 1 && first) return {{a, *first, c}, {*first, b, c}};
        if (parts == 2 && first && second) return {{*first, b, *second}, {a, *first, *second}, {a, *second, c}};
    }
    return {};
}

}  // namespace

EdgeSplits::EdgeSplits(const MotionMesh& mesh, std::size_t triangles) : firstNew_(mesh.positionsOpen.size()) {
    const Places places(mesh);
    struct Shared {
        std::size_t triangles = 0;
        std::vector<Edge> edges;
    };
    std::map<Ends, Shared> all;
    for (const glm::u32vec3& triangle : mesh.topology->triangles)
        for (int i = 0; i < 3; ++i) {
            std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
            if (mesh.positionsOpen[a] == mesh.positionsClose[a] && mesh.positionsOpen[b] == mesh.positionsClose[b])
                continue;
            if (places.ofVertex[a] > places.ofVertex[b]) std::swap(a, b);
            const Ends ends{places.ofVertex[a], places.ofVertex[b]};
            Shared& shared = all[ends];
            ++shared.triangles;
            const auto same = [&](const Edge& edge) { return edge.a == a && edge.b == b; };
            if (std::none_of(shared.edges.begin(), shared.edges.end(), same))
                shared.edges.push_back({a, b, places.sharp[ends.first] != 0 || places.sharp[ends.second] != 0});
        }
    std::vector<std::tuple<double, Ends>> byLength;
    for (const auto& [ends, shared] : all) {
        const Edge& edge = shared.edges.front();
        byLength.emplace_back(-glm::length(mesh.positionsOpen[edge.b] - mesh.positionsOpen[edge.a]), ends);
    }
    std::sort(byLength.begin(), byLength.end());
    std::size_t count = mesh.topology->triangles.size();
    for (const auto& [length, ends] : byLength) {
        if (count >= triangles) break;
        const Shared& shared = all[ends];
        count += shared.triangles;
        for (const Edge& edge : shared.edges) {
            news_[std::minmax(edge.a, edge.b)] = static_cast<std::uint32_t>(firstNew_ + edges_.size());
            edges_.push_back(edge);
        }
    }
}

MeshTopology EdgeSplits::divided(const MeshTopology& bare) const {
    MeshTopology topology = bare;
    topology.triangles.clear();
    topology.triangleMaterials.clear();
    topology.triangleInstances.clear();
    for (std::size_t t = 0; t < bare.triangles.size(); ++t) {
        std::array<std::optional<std::uint32_t>, 3> on;
        for (int i = 0; i < 3; ++i) {
            const Ends ends = std::minmax(bare.triangles[t][i], bare.triangles[t][(i + 1) % 3]);
            if (const auto found = news_.find(ends); found != news_.end())
                on[static_cast<std::size_t>(i)] = found->second;
        }
        for (const glm::u32vec3& triangle : between(bare.triangles[t], on)) {
            topology.triangles.push_back(triangle);
            topology.triangleMaterials.push_back(bare.triangleMaterials[t]);
            topology.triangleInstances.push_back(bare.triangleInstances[t]);
        }
    }
    topology.vertexCount += edges_.size();
    const auto appendMiddles = [this](auto& values) {
        for (const Edge& edge : edges_)
            if (!values.empty()) values.push_back(0.5f * (values[edge.a] + values[edge.b]));
    };
    appendMiddles(topology.textureCoordinates);
    appendMiddles(topology.moreCoordinates);
    appendMiddles(topology.colours);
    return topology;
}

void EdgeSplits::append(std::vector<glm::dvec3>& positions, std::vector<glm::vec3>& normals) const {
    positions.reserve(positions.size() + edges_.size());
    normals.reserve(normals.size() + edges_.size());
    for (const Edge& edge : edges_) {
        const glm::dvec3 a = positions[edge.a], b = positions[edge.b];
        const glm::vec3 normalA = normals[edge.a], normalB = normals[edge.b];
        positions.push_back(edge.crease ? 0.5 * (a + b) : onCurve(a, b, normalA, normalB));
        const glm::vec3 sum = normalA + normalB;
        normals.push_back(glm::dot(sum, sum) > 1e-12f ? glm::normalize(sum) : normalA);
    }
}

}  // namespace timeshade
