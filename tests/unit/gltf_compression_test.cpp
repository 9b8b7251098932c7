// Compressed models: what the libraries' own encoders wrote must be read as the uncompressed file is; damaged streams
// are refused in one line, and what they announce is counted before it is allocated.

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "../broken_gltf/compressed_files.h"
#include "../broken_gltf/loaded.h"
#include "scene/gltf_compression.h"

namespace timeshade {
namespace {

using namespace test;

/// The triangles' corners as places, in an order of their own.
std::vector<std::array<double, 9>> cornersOf(const Scene& scene) {
    const MotionMesh mesh = scene.motionMesh(0, 0);
    std::vector<std::array<double, 9>> all;
    for (const glm::u32vec3& t : mesh.topology->triangles) {
        std::vector<std::array<double, 3>> corners;
        for (int c = 0; c < 3; ++c) {
            const glm::dvec3& p = mesh.positionsOpen[t[c]];
            corners.push_back({p.x, p.y, p.z});
        }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        std::array<double, 9> flat{};
        for (std::size_t i = 0; i < 9; ++i) flat[i] = corners[i / 3][i % 3];
        all.push_back(flat);
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// The file, with one byte changed in many ways, is read or refused in one line, and never needs more than it may.
void expectDamageIsHarmless(const GltfFile& file, std::size_t first, std::size_t length) {
    std::size_t refused = 0, tried = 0;
    for (std::size_t at = 0; at < length; at += 1 + length / 400)
        for (const int change : {0xff, 0x01, 0x80}) {
            GltfFile damaged = file;
            damaged.data[first + at] = static_cast<std::uint8_t>(damaged.data[first + at] ^ change);
            const std::string message = refusal(damaged, {.memoryLimit = std::uint64_t{64} << 20});
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
            refused += message.empty() ? 0u : 1u;
            ++tried;
        }
    EXPECT_GT(refused, tried / 20) << tried;
    for (std::size_t kept = 0; kept < length; kept += 1 + length / 40) {
        GltfFile cut = file;
        for (Json& view : cut.json["bufferViews"])
            if (view.contains("extensions")) view["extensions"]["EXT_meshopt_compression"]["byteLength"] = kept + 1;
        if (!cut.json["bufferViews"][0].contains("extensions")) cut.json["bufferViews"][0]["byteLength"] = kept + 1;
        if (kept + 1 < length) {
            EXPECT_NE(refusal(cut), "") << kept;
        }
    }
}

#ifdef TIMESHADE_MESHOPT

TEST(Meshopt, IsReadAsTheUncompressedFileIs) {
    const Grid grid(20);
    const auto expected = cornersOf(*loaded(plainFile(grid)));
    for (const bool list : {true, false})
        for (const std::size_t size : {2u, 4u}) {
            const auto scene = loaded(meshoptFile(grid, list, size));
            EXPECT_EQ(cornersOf(*scene), expected) << list << " " << size;
            EXPECT_TRUE(scene->notes().empty());
        }
}

TEST(Meshopt, FiltersAreUndone) {
    const Grid grid(3);
    const std::size_t count = grid.vertices();
    std::vector<float> normals, padded;
    for (std::size_t v = 0; v < count; ++v) {
        const glm::vec3 n = glm::normalize(glm::vec3(std::sin(float(v)), 1.0f, std::cos(float(v) * 2.0f)));
        normals.insert(normals.end(), {n.x, n.y, n.z});
        padded.insert(padded.end(), {n.x, n.y, n.z, 0.0f});
    }
    std::vector<std::int8_t> octahedral(4 * count);
    meshopt_encodeFilterOct(octahedral.data(), count, 4, 8, padded.data());
    std::vector<std::uint32_t> exponential(3 * count);
#if MESHOPTIMIZER_VERSION >= 190
    meshopt_encodeFilterExp(exponential.data(), count, 12, 20, grid.positions.data(), meshopt_EncodeExpSharedVector);
#else
    meshopt_encodeFilterExp(exponential.data(), count, 12, 20, grid.positions.data());
#endif

    GltfFile file;
    const int places =
        addMeshopt(file, encodedVertices(exponential.data(), count, 12), count, 12, "ATTRIBUTES", "EXPONENTIAL");
    const int directions =
        addMeshopt(file, encodedVertices(octahedral.data(), count, 4), count, 4, "ATTRIBUTES", "OCTAHEDRAL");
    file.addMesh(
        {{"POSITION", accessor(file, places, 5126, count, "VEC3")},
         {"NORMAL", accessor(file, directions, 5120, count, "VEC3", true)}},
        accessor(file, addMeshopt(file, encodedIndices(grid.indices, count, true), grid.indices.size(), 4, "TRIANGLES"),
                 5125, grid.indices.size(), "SCALAR"));
    file.addRoot({{"mesh", 0}});
    finishMeshopt(file);
    const MotionMesh mesh = loaded(file)->motionMesh(0, 0);
    for (std::size_t v = 0; v < count; ++v)
        for (int c = 0; c < 3; ++c) {
            const std::size_t i = 3 * v + static_cast<std::size_t>(c);
            EXPECT_NEAR(mesh.positionsOpen[v][c], static_cast<double>(grid.positions[i]), 4.0 / (1 << 19)) << v;
            // Two 8-bit coordinates of an octahedron, and their unit vector rounded to 8 bits.
            EXPECT_NEAR(static_cast<double>(mesh.normalsOpen[v][c]), static_cast<double>(normals[i]), 0.02) << v;
        }
}

TEST(Meshopt, WhatAViewSaysIsCheckedFirst) {
    const GltfFile good = meshoptFile(Grid(4), true, 2);
    const std::vector<std::tuple<int, const char*, Json>> broken{{0, "buffer", 7},
                                                                 {0, "buffer", -1},
                                                                 {0, "byteOffset", 1 << 20},
                                                                 {0, "byteLength", 1 << 20},
                                                                 {0, "byteLength", 0},
                                                                 {0, "count", 0},
                                                                 {0, "count", 1.5},
                                                                 {0, "count", "x"},
                                                                 {0, "byteStride", 10},
                                                                 {0, "byteStride", 260},
                                                                 {0, "mode", "POINTS"},
                                                                 {0, "mode", 4},
                                                                 {0, "filter", "FOURIER"},
                                                                 {0, "filter", "QUATERNION"},
                                                                 {0, "filter", "OCTAHEDRAL"},
                                                                 {1, "byteStride", 3},
                                                                 {1, "count", 95},
                                                                 {1, "filter", "EXPONENTIAL"}};
    for (const auto& [view, key, value] : broken) {
        GltfFile file = good;
        file.json["bufferViews"][static_cast<std::size_t>(view)]["extensions"]["EXT_meshopt_compression"][key] = value;
        const std::string message = refusal(file);
        EXPECT_NE(message.find("EXT_meshopt_compression"), std::string::npos) << key << " " << value << message;
    }
    GltfFile missing = good;
    missing.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"].erase("count");
    EXPECT_NE(refusal(missing).find("count is missing"), std::string::npos) << refusal(missing);
    // A huge count of a small stream is counted, not allocated.
    GltfFile huge = good;
    huge.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["count"] = 2'000'000'000;
    EXPECT_NE(refusal(huge, {.memoryLimit = 1 << 28}).find("no room for bufferView 0"), std::string::npos);
    // A view of a buffer without bytes that is not compressed.
    GltfFile bare = good;
    bare.json["bufferViews"][0].erase("extensions");
    EXPECT_NE(refusal(bare).find("bufferView 0"), std::string::npos) << refusal(bare);
}

TEST(Meshopt, DamageIsRefusedOrHarmless) {
    const GltfFile file = meshoptFile(Grid(12), true, 4);
    const Json& own = file.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
    expectDamageIsHarmless(file, own["byteOffset"].get<std::size_t>(), own["byteLength"].get<std::size_t>());
}

#endif

#ifdef TIMESHADE_DRACO

TEST(Draco, IsReadAsTheUncompressedFileIs) {
    const Grid grid(20);
    const auto expected = cornersOf(*loaded(plainFile(grid)));
    for (const int speed : {0, 5, 10})
        for (const int bits : {0, 16}) {
            const auto scene = loaded(dracoFile(grid, dracoStream(grid, speed, bits)));
            const auto found = cornersOf(*scene);
            ASSERT_EQ(found.size(), expected.size()) << speed << " " << bits;
            double worst = 0.0;
            // Of rounded places the order may differ: every corner has its own within half a step.
            for (const auto& t : expected) {
                double nearest = 1e9;
                for (const auto& f : found) {
                    double farthest = 0.0;
                    for (std::size_t i = 0; i < 9; ++i) farthest = std::max(farthest, std::abs(f[i] - t[i]));
                    nearest = std::min(nearest, farthest);
                }
                worst = std::max(worst, nearest);
            }
            EXPECT_LE(worst, bits == 0 ? 0.0 : 0.51 * 20.0 / 65535.0) << speed << " " << bits;
            const auto topology = scene->motionMesh(0, 0).topology;
            for (std::size_t v = 0; v < topology->vertexCount; ++v) {
                const glm::dvec3 p = scene->motionMesh(0, 0).positionsOpen[v];
                EXPECT_NEAR(static_cast<double>(topology->textureCoordinates[v].x), p.x / 8.0, 1e-4);
                if (v > 30) break;
            }
        }
}

TEST(Draco, PrimitivesMayShareAStream) {
    const Grid grid(3);
    GltfFile file = dracoFile(grid, dracoStream(grid, 5, 14));
    Json& primitives = file.json["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    const auto scene = loaded(file);
    EXPECT_EQ(scene->motionMesh(0, 0).topology->triangles.size(), 36u);
    // Accessors of two attributes are not.
    primitives[1]["extensions"]["KHR_draco_mesh_compression"]["attributes"] = {{"TEXCOORD_0", 0}};
    EXPECT_NE(refusal(file).find("another compressed attribute"), std::string::npos) << refusal(file);
}

TEST(Draco, WhatAPrimitiveSaysIsChecked) {
    const Grid grid(3);
    const GltfFile good = dracoFile(grid, dracoStream(grid, 5, 14));
    const std::vector<std::pair<const char*, Json>> broken{{"/bufferView", 9},          {"/bufferView", "0"},
                                                           {"/attributes", 3},          {"/attributes/POSITION", 7},
                                                           {"/attributes/POSITION", 1}, {"/attributes/NORMAL", 0}};
    for (const auto& [place, value] : broken) {
        GltfFile file = good;
        file.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"][Json::json_pointer(place)] =
            value;
        EXPECT_NE(refusal(file).find("KHR_draco_mesh_compression"), std::string::npos) << place << refusal(file);
    }
}

/// A stream of a few bytes may announce billions of faces.
TEST(Draco, WhatAStreamAnnouncesIsCountedFirst) {
    const Grid grid(3);
    for (const int method : {0, 1}) {
        std::vector<std::uint8_t> stream{'D', 'R', 'A', 'C', 'O', 2, 2, 1, static_cast<std::uint8_t>(method), 0, 0};
        if (method == 1) stream.push_back(0);  // how connectivity is traversed
        for (const int times : {1, 2}) {       // both counts: 500 million
            static_cast<void>(times);
            stream.insert(stream.end(), {0x80, 0xca, 0xb5, 0xee, 0x01});
        }
        stream.insert(stream.end(), 200, std::uint8_t{1});
        const std::string message = refusal(dracoFile(grid, stream), {.memoryLimit = 1 << 28});
        EXPECT_NE(message.find("no room for mesh 0 primitive 0"), std::string::npos) << message;
    }
}

TEST(Draco, DamageIsRefusedOrHarmless) {
    const Grid grid(12);
    for (const int speed : {0, 10}) {
        const std::vector<std::uint8_t> stream = dracoStream(grid, speed, 12);
        const GltfFile file = dracoFile(grid, stream);
        expectDamageIsHarmless(file, 0, stream.size());
    }
}

#endif

TEST(Compression, WithoutItsLibraryIsRefusedByName) {
    for (const char* name : {"EXT_meshopt_compression", "KHR_draco_mesh_compression"}) {
        GltfFile file = plainFile(Grid(1));
        file.json["extensionsUsed"] = file.json["extensionsRequired"] = Json::array({name});
        const std::string message = refusal(file);
        EXPECT_EQ(message.empty(), gltf::decodes(name)) << message;
        if (!message.empty()) {
            EXPECT_NE(message.find(name), std::string::npos) << message;
        }
    }
}

}  // namespace
}  // namespace timeshade
