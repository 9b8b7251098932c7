// EXT_mesh_gpu_instancing: every instance is where an ordinary node with the same transforms would be.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../broken_gltf/loaded.h"

namespace timeshade {
namespace {

using namespace test;

Json instancing(const Json& attributes) { return {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}}; }

/// A quad on a node that is moved, turned and scaled itself.
GltfFile quadWith(const Json& attributes, GltfFile file) {
    addQuad(file);
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    file.addRoot({{"mesh", file.json["meshes"].size() - 1},
                  {"translation", {1, 2, 3}},
                  {"rotation", {0.0, 0.6, 0.0, 0.8}},
                  {"scale", {1, 2, 1}},
                  {"extensions", instancing(attributes)}});
    return file;
}

const std::vector<float> translations{0, 0, 0, 5, 0, 0, 0, -4, 2}, scales{1, 1, 1, 2, 0.5f, 1, 3, 1, -1};
const std::vector<float> rotations{0, 0, 0, 1, 0, 0, 1, 0, 0.5f, 0.5f, 0.5f, 0.5f};

/// The same without the extension: a child for each instance.
GltfFile quadsOfNodes() {
    GltfFile file;
    addQuad(file);
    file.addRoot({{"translation", {1, 2, 3}}, {"rotation", {0.0, 0.6, 0.0, 0.8}}, {"scale", {1, 2, 1}}});
    for (std::size_t i = 0; i < 3; ++i) {
        const auto part = [&](const std::vector<float>& of, std::size_t n) {
            return std::vector<float>(of.begin() + static_cast<std::ptrdiff_t>(n * i),
                                      of.begin() + static_cast<std::ptrdiff_t>(n * i + n));
        };
        const int child = file.add("nodes", {{"mesh", 0},
                                             {"translation", part(translations, 3)},
                                             {"rotation", part(rotations, 4)},
                                             {"scale", part(scales, 3)}});
        file.json["nodes"][0]["children"].push_back(child);
    }
    return file;
}

void expectSame(const Scene& instances, const Scene& nodes, double tolerance, double open = 0.0, double close = 0.0) {
    const MotionMesh a = instances.motionMesh(open, close), b = nodes.motionMesh(open, close);
    ASSERT_EQ(a.topology->triangles, b.topology->triangles) << "mirrored ones turned round too";
    EXPECT_EQ(a.topology->triangleInstances, b.topology->triangleInstances);
    for (std::size_t v = 0; v < b.positionsOpen.size(); ++v) {
        EXPECT_LE(glm::length(a.positionsOpen[v] - b.positionsOpen[v]), tolerance) << v;
        EXPECT_LE(glm::length(a.positionsClose[v] - b.positionsClose[v]), tolerance) << v;
    }
}

TEST(Instancing, StandsForNodes) {
    GltfFile file;
    const Json attributes = {{"TRANSLATION", file.vec3s(translations)},
                             {"ROTATION", file.vec4s(rotations)},
                             {"SCALE", file.vec3s(scales)},
                             {"_ID", file.scalars({7, 8, 9})}};
    const auto scene = loaded(quadWith(attributes, file));
    EXPECT_EQ(scene->motionMesh(0, 0).topology->instanceCount, 3u);
    expectSame(*scene, *loaded(quadsOfNodes()), 1e-6);
    for (const std::string& note : scene->notes()) EXPECT_EQ(note.find("instancing"), std::string::npos) << note;
}

TEST(Instancing, RotationsMayBeNormalisedIntegers) {
    const auto withRotations = [&](int bits) {
        GltfFile file;
        std::vector<std::int8_t> bytes;
        std::vector<std::int16_t> shorts;
        for (const float r : rotations) {
            bytes.push_back(static_cast<std::int8_t>(std::lround(r * 127.0f)));
            shorts.push_back(static_cast<std::int16_t>(std::lround(r * 32767.0f)));
        }
        const int rotation =
            bits == 8 ? file.addAccessor(bytes, "VEC4", 4, true) : file.addAccessor(shorts, "VEC4", 4, true);
        const Json attributes = {
            {"TRANSLATION", file.vec3s(translations)}, {"ROTATION", rotation}, {"SCALE", file.vec3s(scales)}};
        return loaded(quadWith(attributes, file));
    };
    expectSame(*withRotations(8), *loaded(quadsOfNodes()), 1e-6);
    expectSame(*withRotations(16), *loaded(quadsOfNodes()), 1e-6);
}

TEST(Instancing, EachAttributeAloneIsEnough) {
    for (const char* name : {"TRANSLATION", "SCALE"}) {
        GltfFile file;
        const Json attributes = {{name, file.vec3s(translations)}};
        EXPECT_EQ(loaded(quadWith(attributes, file))->motionMesh(0, 0).topology->triangles.size(), 6u) << name;
    }
    EXPECT_EQ(loaded(quadWith(Json::object(), {}))->motionMesh(0, 0).topology->triangles.size(), 2u) << "no instances";
}

TEST(Instancing, FollowsItsNode) {
    const auto animated = [](GltfFile file) {
        file.animate(0, "translation", {0, 1}, file.vec3s({0, 0, 0, 8, 0, 0}));
        return loaded(file);
    };
    GltfFile file;
    const Json attributes = {
        {"TRANSLATION", file.vec3s(translations)}, {"ROTATION", file.vec4s(rotations)}, {"SCALE", file.vec3s(scales)}};
    expectSame(*animated(quadWith(attributes, file)), *animated(quadsOfNodes()), 1e-6, 0.25, 0.75);
}

TEST(Instancing, MorphWeightsAreThoseOfAll) {
    GltfFile file;
    const Json attributes = {{"TRANSLATION", file.vec3s({0, 0, 0, 5, 0, 0})}};
    GltfFile whole = quadWith(attributes, file);
    whole.json["meshes"][0]["primitives"][0]["targets"] =
        Json::array({{{"POSITION", whole.vec3s({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1})}}});
    whole.animate(0, "weights", {0, 1}, whole.scalars({0, 1}));
    const MotionMesh mesh = loaded(whole)->motionMesh(0.0, 0.5);
    for (std::size_t v = 0; v < 8; ++v)
        EXPECT_NEAR(glm::length(mesh.positionsClose[v] - mesh.positionsOpen[v]), 0.5, 1e-6) << v;
}

TEST(Instancing, WhatIsWrongIsSaidInOneLine) {
    struct Case {
        Json attributes;
        std::string mentions;
        GltfFile file;
    };
    std::vector<Case> cases;
    {
        GltfFile file;
        const Json unlike = {{"TRANSLATION", file.vec3s(translations)}, {"SCALE", file.vec3s({1, 1, 1})}};
        cases.push_back({unlike, "SCALE has 1 elements, TRANSLATION has 3", file});
    }
    {
        GltfFile file;
        const Json still = {{"ROTATION", file.vec4s({0, 0, 0, 1, 0, 0, 0, 0})}};
        cases.push_back({still, "ROTATION: that of instance 1 is no rotation", file});
    }
    {
        GltfFile file;
        const Json shape = {{"SCALE", file.vec4s({1, 1, 1, 1})}};
        cases.push_back({shape, "node 0 instances SCALE", file});
    }
    cases.push_back({{{"TRANSLATION", 400}}, "TRANSLATION is accessor 400", {}});
    cases.push_back({{{"TRANSLATION", "one"}}, "node", {}});
    for (const Case& c : cases) {
        const std::string said = refusal(quadWith(c.attributes, c.file));
        EXPECT_NE(said.find(c.mentions), std::string::npos) << said << "\nexpected " << c.mentions;
        EXPECT_EQ(said.find('\n'), std::string::npos);
    }
}

/// Of elements without bytes behind them, which are all zeros, a small file may have very many.
TEST(Instancing, HasTheLimitOfAllTriangles) {
    GltfFile file;
    const int many = file.add("accessors", {{"componentType", 5126}, {"count", 1000000}, {"type", "VEC3"}});
    GltfOptions options;
    options.maxTriangles = 1'999'999;
    const std::string said = refusal(quadWith({{"TRANSLATION", many}}, file), options);
    EXPECT_NE(said.find("1000000 of 2 triangles each; the limit is 1999999"), std::string::npos) << said;
}

/// A budget that takes the file itself has no room for a million instances, and refuses before they are made.
TEST(Instancing, IsCountedBeforeItIsExpanded) {
    GltfFile file;
    const int many = file.add("accessors", {{"componentType", 5126}, {"count", 1000000}, {"type", "VEC3"}});
    GltfOptions options;
    options.memoryLimit = 64u << 20;
    const std::string said = refusal(quadWith({{"TRANSLATION", many}}, file), options);
    EXPECT_NE(said.find("node 0 instances"), std::string::npos) << said;
    EXPECT_NE(said.find("limit"), std::string::npos) << said;
}

TEST(Instancing, OfASkinIsDrawnOnce) {
    GltfFile file = fileWithEverything();
    const int places = file.vec3s(translations);
    file.json["nodes"][2]["extensions"] = instancing({{"TRANSLATION", places}});
    const auto scene = loaded(file);
    EXPECT_EQ(std::count_if(scene->notes().begin(), scene->notes().end(),
                            [](const std::string& note) {
                                return note.find("node 2 has a skin and 3 instances; one is drawn") !=
                                       std::string::npos;
                            }),
              1);
    EXPECT_EQ(scene->motionMesh(0, 0).topology->triangles.size(),
              loaded(fileWithEverything())->motionMesh(0, 0).topology->triangles.size());
}

}  // namespace
}  // namespace timeshade
