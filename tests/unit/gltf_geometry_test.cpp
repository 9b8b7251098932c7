// What triangles a file becomes, and where its vertices go: small files with known results.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "../broken_gltf/loaded.h"

namespace timeshade {
namespace {

using namespace test;

void expectNear(const glm::dvec3& found, const glm::dvec3& expected, double tolerance = 1e-6) {
    EXPECT_LE(glm::length(found - expected), tolerance) << found.x << " " << found.y << " " << found.z << ", expected "
                                                        << expected.x << " " << expected.y << " " << expected.z;
}

/// The unit-quad's corners in an order that makes sense for lists, strips and fans of its two triangles.
GltfFile quadOfMode(int mode, const std::vector<float>& corners) {
    GltfFile file;
    file.addMesh({{"POSITION", file.vec3s(corners)}}, -1, mode);
    file.addRoot({{"mesh", 0}});
    return file;
}

void expectUnitQuadFacingZ(const Scene& scene) {
    const MotionMesh mesh = scene.motionMesh(0, 0);
    ASSERT_EQ(mesh.topology->triangles.size(), 2u);
    double area = 0.0;
    for (const glm::u32vec3& t : mesh.topology->triangles) {
        const glm::dvec3 a = mesh.positionsOpen[t.x];
        const glm::dvec3 normal = glm::cross(mesh.positionsOpen[t.y] - a, mesh.positionsOpen[t.z] - a);
        EXPECT_GT(normal.z, 0.0);
        area += 0.5 * normal.z;
    }
    EXPECT_NEAR(area, 1.0, 1e-12);
    for (const glm::vec3& normal : mesh.normalsOpen) EXPECT_NEAR(static_cast<double>(normal.z), 1.0, 1e-6);
}

TEST(GltfGeometry, ListsStripsAndFansWindAlike) {
    expectUnitQuadFacingZ(*loaded(quadOfMode(4, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0})));
    expectUnitQuadFacingZ(*loaded(quadOfMode(5, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})));
    expectUnitQuadFacingZ(*loaded(quadOfMode(6, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0})));
}

template <typename Index>
void expectQuadWithIndices() {
    GltfFile file;
    const int positions = file.vec3s({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    file.addMesh({{"POSITION", positions}}, file.addAccessor<Index>({0, 1, 2, 0, 2, 3, 1, 1, 3}, "SCALAR", 1));
    file.addRoot({{"mesh", 0}});
    expectUnitQuadFacingZ(*loaded(file));  // the ninth index makes a triangle without area, which is dropped
}

TEST(GltfGeometry, IndicesOfAllWidths) {
    expectQuadWithIndices<std::uint8_t>();
    expectQuadWithIndices<std::uint16_t>();
    expectQuadWithIndices<std::uint32_t>();
}

TEST(GltfGeometry, MirroredNodesKeepTheirFront) {
    GltfFile file;
    addQuad(file);
    file.addRoot({{"mesh", 0}, {"scale", {-1, 1, 1}}});
    const auto scene = loaded(file);
    expectUnitQuadFacingZ(*scene);
    EXPECT_GE(notesWith(*scene, "mirrored"), 1u);
}

TEST(GltfGeometry, PointsAndLinesAreSkippedWithANote) {
    GltfFile file;
    addQuad(file);
    Json points = file.json["meshes"][0]["primitives"][0];
    points["mode"] = 0;
    file.json["meshes"][0]["primitives"].push_back(points);
    file.addRoot({{"mesh", 0}});
    const auto scene = loaded(file);
    EXPECT_EQ(scene->motionMesh(0, 0).topology->vertexCount, 4u);
    EXPECT_GE(notesWith(*scene, "1 primitives of points"), 1u);
}

TEST(GltfGeometry, NodesComposeInDoublePrecision) {
    GltfFile file;
    addQuad(file);
    const double half = std::sqrt(0.5);
    file.addRoot(
        {{"translation", {10, 0, 0}}, {"rotation", {0, 0, half, half}}, {"children", {1}}});  // a quarter turn about z
    file.add("nodes", {{"matrix", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 1, 0, 0, 1}}, {"mesh", 0}});
    const MotionMesh mesh = loaded(file)->motionMesh(0, 0);
    expectNear(mesh.positionsOpen[0], {10, 1, 0}, 1e-12);
    expectNear(mesh.positionsOpen[1], {10, 3, 0}, 1e-12);
    expectNear(mesh.positionsOpen[3], {8, 1, 0}, 1e-12);
}

TEST(GltfGeometry, InstancesShareAMeshAndNodesOutsideTheSceneStayOut) {
    GltfFile file;
    addQuad(file);
    file.addRoot({{"mesh", 0}});
    file.addRoot({{"mesh", 0}, {"translation", {5, 0, 0}}});
    file.add("nodes", {{"mesh", 0}, {"translation", {500, 0, 0}}});
    const auto scene = loaded(file);
    const MotionMesh mesh = scene->motionMesh(0, 0);
    EXPECT_EQ(mesh.topology->vertexCount, 8u);
    EXPECT_EQ(mesh.topology->instanceCount, 2u);
    EXPECT_EQ(mesh.topology->triangleInstances, (std::vector<std::uint32_t>{0, 0, 1, 1}));
    EXPECT_DOUBLE_EQ(scene->bounds().high.x, 6.0);
}

TEST(GltfGeometry, SparseValuesReplaceAndStandAlone) {
    const auto scene = loaded(fileWithEverything());
    const MotionMesh mesh = scene->motionMesh(0, 0);
    const std::vector<glm::dvec3> expected{{0, 0, 0}, {1, 0, 2}, {1, 1, 2}, {0, 0, 0}};
    for (std::size_t i = 0; i < 4; ++i) expectNear(mesh.positionsOpen[8 + i], expected[i]);

    GltfFile file;  // no values but the sparse ones: the others are zero
    const std::vector<std::uint16_t> places{1, 3};
    const std::vector<float> values{1, 0, 0, 0, 1, 0};
    file.add("accessors", {{"componentType", 5126},
                           {"count", 4},
                           {"type", "VEC3"},
                           {"sparse",
                            {{"count", 2},
                             {"indices", {{"bufferView", file.addView(places.data(), 4)}, {"componentType", 5123}}},
                             {"values", {{"bufferView", file.addView(values.data(), 24)}}}}}});
    file.addMesh({{"POSITION", 0}}, file.addAccessor<std::uint8_t>({0, 1, 3}, "SCALAR", 1));
    file.addRoot({{"mesh", 0}});
    const MotionMesh alone = loaded(file)->motionMesh(0, 0);
    expectNear(alone.positionsOpen[1], {1, 0, 0});
    expectNear(alone.positionsOpen[2], {0, 0, 0});
    expectNear(alone.positionsOpen[3], {0, 1, 0});
}

TEST(GltfGeometry, QuantisedAttributesAndStrides) {
    GltfFile file;
    file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    // Three shorts and two bytes of padding per vertex.
    const std::vector<std::int16_t> positions{0, 0, 0, 99, 32767, 0, 0, 99, 0, -32768, 0, 99};
    const int view = file.addView(positions.data(), 24);
    file.json["bufferViews"][0]["byteStride"] = 8;
    file.add("accessors",
             {{"bufferView", view}, {"componentType", 5122}, {"count", 3}, {"type", "VEC3"}, {"normalized", true}});
    const int normals =
        file.addAccessor<std::int8_t>({0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 0, 0, 127, 0, 0, 0}, "VEC4", 4, true);
    file.json["accessors"][static_cast<std::size_t>(normals)]["type"] = "VEC3";
    file.json["accessors"][static_cast<std::size_t>(normals)]["count"] = 3;
    file.json["bufferViews"][1]["byteStride"] = 4;
    const int coordinates = file.addAccessor<std::uint16_t>({0, 0, 65535, 0, 0, 65535}, "VEC2", 2, true);
    file.addMesh({{"POSITION", 0}, {"NORMAL", normals}, {"TEXCOORD_0", coordinates}});
    file.addRoot({{"mesh", 0}, {"scale", {2, 2, 2}}});
    const MotionMesh mesh = loaded(file)->motionMesh(0, 0);
    expectNear(mesh.positionsOpen[1], {2, 0, 0});
    expectNear(mesh.positionsOpen[2], {0, -2, 0});  // clamped: -32768 is no less than -1
    EXPECT_EQ(mesh.topology->textureCoordinates[1], glm::vec2(1, 0));
    EXPECT_EQ(mesh.normalsOpen[0], glm::vec3(0, 0, 1));

    GltfFile raw;  // not normalised: 100 means 100
    const int bytes = raw.addAccessor<std::int8_t>({0, 0, 0, 0, 100, 0, 0, 0, 0, 50, 0, 0}, "VEC4", 4);
    raw.json["accessors"][static_cast<std::size_t>(bytes)]["type"] = "VEC3";
    raw.json["bufferViews"][0]["byteStride"] = 4;
    raw.addMesh({{"POSITION", bytes}});
    raw.addRoot({{"mesh", 0}});
    expectNear(loaded(raw)->motionMesh(0, 0).positionsOpen[1], {100, 0, 0});
}

TEST(GltfGeometry, NormalsTurnWithTheInverseTranspose) {
    GltfFile file;
    const int positions = file.vec3s({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const float d = std::sqrt(0.5f);
    file.addMesh({{"POSITION", positions}, {"NORMAL", file.vec3s({d, d, 0, 0, 0, 2, 0, 0, 0})}});
    file.addRoot({{"mesh", 0}, {"scale", {2, 1, 1}}});
    const MotionMesh mesh = loaded(file)->motionMesh(0, 0);
    const glm::dvec3 expected = glm::normalize(glm::dvec3(0.5, 1.0, 0.0));
    expectNear(glm::dvec3(mesh.normalsOpen[0]), expected);
    expectNear(glm::dvec3(mesh.normalsOpen[1]), {0, 0, 1});  // made unit
    expectNear(glm::dvec3(mesh.normalsOpen[2]), {0, 0, 1});  // of no length in the file: the triangle's own
}

TEST(GltfGeometry, SkinsBlendAndIgnoreTheirNode) {
    GltfFile file;
    const int positions = file.vec3s({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int joints = file.addAccessor<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 9, 9}, "VEC4", 4);
    const int weights = file.vec4s({1, 0, 0, 0, 1, 3, 0, 0, 0, 0, 0, 0});  // the second sums to 4, the third to nothing
    file.addMesh({{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}});
    file.addRoot({{"translation", {0, 0, 1}}});
    file.addRoot({{"translation", {0, 0, 5}}});
    std::vector<float> inverse{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -1, 1,
                               1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -1, 1};
    file.add("skins", {{"joints", {0, 1}}, {"inverseBindMatrices", file.addAccessor(inverse, "MAT4", 16)}});
    file.addRoot({{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}});
    const MotionMesh mesh = loaded(file)->motionMesh(0, 0);
    expectNear(mesh.positionsOpen[0], {0, 0, 0});
    expectNear(mesh.positionsOpen[1], {1, 0, 3});    // 0.75 of joint 1's lift of 4
    expectNear(mesh.positionsOpen[2], {100, 1, 0});  // follows no joint: stays with its node
}

TEST(GltfGeometry, MorphTargetsMovePositionsAndNormals) {
    GltfFile file;
    addQuad(file);
    Json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["attributes"]["NORMAL"] = file.vec3s({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int up = file.vec3s({0, 0, 4, 0, 0, 4, 0, 0, 4, 0, 0, 4});
    const int tilt = file.vec3s({0, 2, 0, 0, 2, 0, 0, 2, 0, 0, 2, 0});
    primitive["targets"] = Json::array({{{"POSITION", up}, {"NORMAL", tilt}}, {{"POSITION", tilt}}});
    file.json["meshes"][0]["weights"] = {0.5, 0};
    file.addRoot({{"mesh", 0}});
    file.addRoot({{"mesh", 0}, {"weights", {0, 1}}});  // a node's weights replace its mesh's
    const MotionMesh mesh = loaded(file)->motionMesh(0, 0);
    expectNear(mesh.positionsOpen[0], {0, 0, 2});
    expectNear(glm::dvec3(mesh.normalsOpen[0]), glm::normalize(glm::dvec3(0, 1, 1)));
    expectNear(mesh.positionsOpen[4], {0, 2, 0});
}

TEST(GltfGeometry, TexturesAndMaterialsArrive) {
    const auto scene = loaded(fileWithEverything());
    ASSERT_EQ(scene->images().size(), 1u);
    EXPECT_EQ(scene->images()[0].width, 1);
    EXPECT_EQ(scene->images()[0].rgba.size(), 4u);
    EXPECT_EQ(scene->materials()[0].baseColor.image, 0);
    const MotionMesh mesh = scene->motionMesh(0, 0);
    EXPECT_EQ(mesh.topology->triangleMaterials, (std::vector<std::uint32_t>{0, 0, 1, 1, 1, 1}));  // 1: glTF's default
    EXPECT_EQ(scene->materials()[1].name, "default");
}

}  // namespace
}  // namespace timeshade
