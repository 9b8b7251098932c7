// Two thousand damaged copies of a valid file: each loads or is refused with an Error. The seed is fixed, so that a
// failure can be repeated; the mutation's number is printed with it.

#include <random>

#include <gtest/gtest.h>

#include "../broken_gltf/gltf_writer.h"
#include "core/error.h"
#include "scene/gltf_scene.h"

namespace timeshade {
namespace {

using namespace test;

bool finite(const std::vector<glm::dvec3>& positions) {
    for (const glm::dvec3& p : positions)
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
    return true;
}

void expectSound(const Scene& scene) {
    const MotionMesh mesh = scene.motionMesh(scene.duration() * 0.3, scene.duration() * 0.31);
    EXPECT_TRUE(finite(mesh.positionsOpen) && finite(mesh.positionsClose));
    EXPECT_EQ(mesh.normalsOpen.size(), mesh.topology->vertexCount);
    for (const glm::u32vec3& triangle : mesh.topology->triangles)
        for (int corner = 0; corner < 3; ++corner) ASSERT_LT(triangle[corner], mesh.topology->vertexCount);
    for (const std::uint32_t material : mesh.topology->triangleMaterials) ASSERT_LT(material, scene.materials().size());
    for (std::size_t i = 0; i < scene.cameras().size(); ++i) EXPECT_GT(scene.camera(i, 0.1).nearDistance, 0.0);
    const LightPose light = scene.light(0.1);
    EXPECT_LT(light.innerConeAngle, light.outerConeAngle);
    EXPECT_TRUE(std::isfinite(light.position.x) && light.outerConeAngle <= 1.48);
}

void expectSceneOrError(const std::filesystem::path& path) {
    try {
        expectSound(*loadGltf(path));
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
}

TEST(FuzzedGltf, DamagedBytes) {
    const TemporaryFolder folder;
    const ByteList whole = fileWithEverything().glb();
    std::mt19937 random(20240601);
    for (int mutation = 0; mutation < 2000; ++mutation) {
        SCOPED_TRACE(mutation);
        ByteList bytes = whole;
        const auto changes = 1 + random() % 8;
        for (std::uint32_t i = 0; i < changes; ++i)
            bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
        expectSceneOrError(folder.write("fuzz.glb", bytes));
    }
}

/// Bytes rarely give valid JSON with absurd content, so here the numbers in it are replaced.
TEST(FuzzedGltf, DamagedNumbers) {
    const TemporaryFolder folder;
    const GltfFile whole = fileWithEverything();
    const Json flat = whole.json.flatten();
    std::vector<std::string> numbers;
    for (const auto& item : flat.items())
        if (item.value().is_number()) numbers.push_back(item.key());
    const std::vector<Json> values{0,          1,  2,   3,     5,     7,           13,      255,    65536,
                                   2147483647, -1, 0.5, 1e300, -1e18, 4294967295u, nullptr, "text", Json::array()};
    std::mt19937 random(7);
    for (int mutation = 0; mutation < 2000; ++mutation) {
        SCOPED_TRACE(mutation);
        GltfFile file = whole;
        const auto changes = 1 + random() % 3;
        for (std::uint32_t i = 0; i < changes; ++i) {
            const Json::json_pointer place(numbers[random() % numbers.size()]);
            if (file.json.contains(place)) file.json[place] = values[random() % values.size()];
        }
        expectSceneOrError(folder.write("fuzz.glb", file.glb()));
    }
}

}  // namespace
}  // namespace timeshade
