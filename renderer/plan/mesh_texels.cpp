#include "plan/mesh_texels.h"

#include "core/check.h"
#include "core/parallel.h"

namespace timeshade {

namespace {

/// As many vertices or triangles as are worth a thread.
constexpr std::size_t together = 4096;

}  // namespace

MeshTexels packMesh(const MotionMesh& mesh, const std::vector<Material>& materials, const glm::dvec3& origin) {
    const MeshTopology& topology = *mesh.topology;
    CHECK_EQ(mesh.positionsOpen.size(), topology.vertexCount);
    CHECK_EQ(mesh.positionsClose.size(), topology.vertexCount);
    CHECK_EQ(mesh.normalsOpen.size(), topology.vertexCount);
    CHECK_EQ(mesh.normalsClose.size(), topology.vertexCount);
    MeshTexels texels;
    texels.positions.resize(topology.triangles.size() * TRIANGLE_POSITION_TEXELS);
    texels.shading.resize(topology.triangles.size() * TRIANGLE_SHADING_TEXELS);
    texels.vertices.resize(2 * mesh.positionsOpen.size());
    std::vector<glm::vec3> open(mesh.positionsOpen.size()), close(mesh.positionsClose.size());
    forEachOf(open.size(), together, [&](std::size_t i) {
        texels.vertices[2 * i] = open[i] = glm::vec3(mesh.positionsOpen[i] - origin);
        texels.vertices[2 * i + 1] = close[i] = glm::vec3(mesh.positionsClose[i] - origin);
    });
    forEachOf(topology.triangles.size(), together, [&](std::size_t i) {
        glm::vec4* position = texels.positions.data() + i * TRIANGLE_POSITION_TEXELS;
        glm::vec4* shading = texels.shading.data() + i * TRIANGLE_SHADING_TEXELS;
        const glm::u32vec3 v = topology.triangles[i];
        const std::uint32_t material = topology.triangleMaterials[i];
        CHECK_LT(material, materials.size());
        const glm::vec3 &a0 = open[v.x], &a1 = open[v.y], &a2 = open[v.z], &b0 = close[v.x], &b1 = close[v.y],
                        &b2 = close[v.z];
        position[0] = {a0.x, a0.y, a0.z, a1.x};
        position[1] = {a1.y, a1.z, a2.x, a2.y};
        position[2] = {a2.z, b0.x, b0.y, b0.z};
        position[3] = {b1.x, b1.y, b1.z, b2.x};
        position[4] = {b2.y, b2.z, materials[material].doubleSided ? 1.0f : 0.0f, static_cast<float>(material)};
        const glm::vec3 &m0 = mesh.normalsOpen[v.x], &m1 = mesh.normalsOpen[v.y], &m2 = mesh.normalsOpen[v.z];
        const glm::vec3 &n0 = mesh.normalsClose[v.x], &n1 = mesh.normalsClose[v.y], &n2 = mesh.normalsClose[v.z];
        const glm::vec2 &t0 = topology.textureCoordinates[v.x], &t1 = topology.textureCoordinates[v.y],
                        &t2 = topology.textureCoordinates[v.z];
        shading[0] = {m0.x, m0.y, m0.z, m1.x};
        shading[1] = {m1.y, m1.z, m2.x, m2.y};
        shading[2] = {m2.z, n0.x, n0.y, n0.z};
        shading[3] = {n1.x, n1.y, n1.z, n2.x};
        shading[4] = {n2.y, n2.z, t0.x, t0.y};
        shading[5] = {t1.x, t1.y, t2.x, t2.y};
    });
    return texels;
}

std::size_t countMovingTriangles(const MotionMesh& mesh) {
    std::vector<char> moves(mesh.positionsOpen.size());
    for (std::size_t i = 0; i < moves.size(); ++i) moves[i] = mesh.positionsOpen[i] != mesh.positionsClose[i];
    std::size_t count = 0;
    for (const glm::u32vec3& v : mesh.topology->triangles) count += (moves[v.x] || moves[v.y] || moves[v.z]) ? 1u : 0u;
    return count;
}

}  // namespace timeshade
