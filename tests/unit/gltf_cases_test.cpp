// What people report of other importers, by its kind: mirrored poses and matrices, rounded matrices, links and URIs,
// extensions, and what is left out.

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "../broken_gltf/loaded.h"

namespace timeshade {
namespace {

using namespace test;
namespace fs = std::filesystem;

GltfFile quadAlone() {
    GltfFile file;
    addQuad(file);
    file.addRoot({{"mesh", 0}});
    return file;
}

/// The normal of the first triangle as its winding has it, at u = 0.
glm::dvec3 facing(const Scene& scene, double open, double close) {
    const MotionMesh mesh = scene.motionMesh(open, close);
    const glm::u32vec3 t = mesh.topology->triangles[0];
    const auto& p = mesh.positionsOpen;
    return glm::normalize(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]));
}

TEST(MirroredByAnimation, NodesFaceAsTheirPoseHasIt) {
    for (const int axis : {0, 1}) {
        std::vector<float> scales{1, 1, 1, -1, 1, 1};
        if (axis == 1) std::swap(scales[3], scales[4]);
        GltfFile file = quadAlone();
        file.animate(0, "scale", {0, 1}, file.vec3s(scales));
        const auto scene = loaded(file);
        // A quad in a plane that is mirrored within it still faces the same way.
        for (const double time : {0.0, 0.2, 0.8, 1.0}) EXPECT_NEAR(facing(*scene, time, time).z, 1.0, 1e-9) << time;
        EXPECT_NEAR(facing(*scene, 0.6, 0.7).z, 1.0, 1e-9);
    }
    // The other way round: mirrored at rest, not later. Across the plane, it faces backwards.
    GltfFile back = quadAlone();
    back.json["nodes"][0]["scale"] = {1, 1, -1};
    back.animate(0, "scale", {0, 1}, back.vec3s({1, 1, -1, 1, 1, 1}));
    EXPECT_NEAR(facing(*loaded(back), 0.1, 0.1).z, -1.0, 1e-9);
    EXPECT_NEAR(facing(*loaded(back), 0.9, 0.9).z, 1.0, 1e-9);
}

TEST(MirroredByAnimation, ParentsAndBonesDoItToo) {
    GltfFile parent = quadAlone();
    parent.add("nodes", {{"children", {0}}});
    parent.json["scenes"][0]["nodes"] = {1};
    parent.animate(1, "scale", {0, 1}, parent.vec3s({1, 1, 1, -2, 1, 1}), "STEP");
    EXPECT_NEAR(facing(*loaded(parent), 1.0, 1.0).z, 1.0, 1e-9);
    EXPECT_NEAR(facing(*loaded(parent), 0.5, 0.5).z, 1.0, 1e-9);

    GltfFile bone = quadAlone();
    bone.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] =
        bone.addAccessor<std::uint8_t>(std::vector<std::uint8_t>(16, 0), "VEC4", 4);
    bone.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] =
        bone.vec4s({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    bone.addRoot({{"name", "joint"}});
    bone.add("skins", {{"joints", {1}}});
    bone.json["nodes"][0]["skin"] = 0;
    bone.animate(1, "scale", {0, 1}, bone.vec3s({1, 1, 1, 1, -1, 1}));
    for (const double time : {0.1, 0.9}) EXPECT_NEAR(facing(*loaded(bone), time, time).z, 1.0, 1e-9) << time;
}

TEST(MirroredByAnimation, EqualWindingsShareOneTopology) {
    GltfFile file = quadAlone();
    file.animate(0, "scale", {0, 1}, file.vec3s({1, 1, 1, -1, 1, 1}));
    const auto scene = loaded(file);
    EXPECT_EQ(scene->motionMesh(0.0, 0.1).topology, scene->motionMesh(0.2, 0.3).topology);
    EXPECT_EQ(scene->motionMesh(0.6, 0.7).topology, scene->motionMesh(0.8, 0.9).topology);
    EXPECT_NE(scene->motionMesh(0.0, 0.1).topology, scene->motionMesh(0.8, 0.9).topology);
}

/// Mirrored along each axis, and along one after a turn: a matrix that is animated stands as it does where it is not.
TEST(MirroredMatrices, AnimatedOnesStandAsStillOnes) {
    const double c = std::cos(0.7), s = std::sin(0.7);
    const std::vector<std::vector<double>> matrices{{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 4, 5, 1},
                                                    {1, 0, 0, 0, 0, -2, 0, 0, 0, 0, 1, 0, 3, 4, 5, 1},
                                                    {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 3, 4, 5, 1},
                                                    {-c, -s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 3, 4, 5, 1},
                                                    {-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 3, 4, 5, 1}};
    for (const std::vector<double>& matrix : matrices) {
        GltfFile still = quadAlone();
        still.json["nodes"][0]["matrix"] = matrix;
        GltfFile animated = still;
        animated.animate(0, "translation", {0, 1}, animated.vec3s({3, 4, 5, 3, 4, 5}));
        const MotionMesh a = loaded(still)->motionMesh(0, 0), b = loaded(animated)->motionMesh(0, 0);
        for (std::size_t v = 0; v < 4; ++v) EXPECT_LE(glm::length(a.positionsOpen[v] - b.positionsOpen[v]), 1e-12) << v;
    }
}

TEST(MirroredMatrices, ACameraBelowOneLooksTheSameWayAndStaysUpright) {
    for (const int axis : {0, 1, 2}) {
        GltfFile file = quadAlone();
        file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}});
        file.add("nodes", {{"camera", 0}, {"translation", {0, 0, 5}}});
        Json scale = {1, 1, 1};
        scale[static_cast<std::size_t>(axis)] = -1;
        file.addRoot({{"children", {1}}, {"scale", scale}});
        const CameraPose pose = loaded(file)->camera(0, 0);
        EXPECT_NEAR(glm::determinant(pose.axes), 1.0, 1e-12);
        EXPECT_NEAR(pose.axes[1].y, axis == 1 ? -1.0 : 1.0, 1e-12);
        EXPECT_NEAR(pose.axes[2].z, axis == 2 ? -1.0 : 1.0, 1e-12);
    }
}

TEST(RoundedMatrices, OpenAndOthersDoNot) {
    for (const auto& [place, value, good] : {std::tuple{15, 0.99999994, true},
                                             {15, 1.0000001, true},
                                             {3, 1e-9, true},
                                             {7, -3e-8, true},
                                             {15, 0.9, false},
                                             {15, 0.0, false},
                                             {11, 0.01, false}}) {
        GltfFile file = quadAlone();
        Json matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0.8, 0, 1};
        matrix[static_cast<std::size_t>(place)] = value;
        file.json["nodes"][0]["matrix"] = matrix;
        EXPECT_EQ(refusal(file).empty(), good) << place << " " << value << " " << refusal(file);
        if (!good) continue;
        EXPECT_NEAR(loaded(file)->motionMesh(0, 0).positionsOpen[0].y, 0.8, 1e-12);
    }
}

/// The buffer named by a URI, in a folder that has the files that are named; "" where it loads.
std::string refusalOf(const std::string& uri, const std::vector<std::string>& files,
                      const std::vector<std::pair<std::string, std::string>>& links = {}) {
    const TemporaryFolder folder;
    const GltfFile file = quadAlone();
    fs::create_directories(folder.path() / "model" / "sub");
    fs::create_directories(folder.path() / "blobs");
    for (const std::string& name : files) folder.write(name, file.data);
    for (const auto& [name, target] : links) fs::create_symlink(target, folder.path() / name);
    try {
        loadGltf(file.saveSplit(folder, "model/model.gltf", uri));
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(FileNames, ColonsAndDotsOfUris) {
    EXPECT_EQ(refusalOf("12%3A30.bin", {"model/12:30.bin"}), "");
    EXPECT_EQ(refusalOf("c%3a.bin", {"model/c:.bin"}), "");
    EXPECT_EQ(refusalOf("./a:b.bin", {"model/a:b.bin"}), "");
    EXPECT_EQ(refusalOf("sub/../plain.bin", {"model/plain.bin"}), "");
    EXPECT_EQ(refusalOf("./sub/./x.bin", {"model/sub/x.bin"}), "");
    EXPECT_EQ(refusalOf("sub/%2E%2E/plain.bin", {"model/plain.bin"}), "");
    for (const char* uri : {"c:x.bin", "file:x.bin", "http:x.bin", "../x.bin", "sub/../../x.bin", "%2e%2e/x.bin",
                            "sub%2F..%2F..%2Fx.bin"})
        EXPECT_NE(refusalOf(uri, {"x.bin", "model/c:x.bin", "model/file:x.bin"}), "") << uri;
}

TEST(FileNames, LinksToWhatIsNamedByItsContent) {
    const std::string digits = "5" + std::string(63, 'a');
    for (const std::string& name : std::vector<std::string>{"0123abcd", digits, "sha256-" + digits, digits + ".bin",
                                                            "SHA256E-s840--" + digits + ".bin"})
        EXPECT_EQ(refusalOf("b.bin", {"blobs/" + name}, {{"model/b.bin", "../blobs/" + name}}), "") << name;
    for (const std::string name :
         {"secret", "id_rsa", "20231129", "20231129.bin", "0123abc", "0123abcdx", "my-0123abcd", "passwd.0123abcd"})
        EXPECT_NE(refusalOf("b.bin", {"blobs/" + name}, {{"model/b.bin", "../blobs/" + name}}), "") << name;
    // A folder that leads outside, whatever the file in it is called; and a link within the folder as ever.
    EXPECT_NE(refusalOf("up/0123abcd", {"blobs/0123abcd"}, {{"model/up", "../blobs"}}), "");
    EXPECT_EQ(refusalOf("b.bin", {"model/sub/c.bin"}, {{"model/b.bin", "sub/c.bin"}}), "");
    EXPECT_NE(refusalOf("b.bin", {}, {{"model/b.bin", "/dev/zero"}}), "");
}

TEST(Extensions, ThatChangeLooksAloneOpenWithOneNote) {
    for (const char* name : {"KHR_materials_unlit", "KHR_materials_made_up", "KHR_xmp_json_ld", "EXT_texture_webp"}) {
        GltfFile file = quadAlone();
        file.json["extensionsUsed"] = file.json["extensionsRequired"] = Json::array({name});
        EXPECT_EQ(notesWith(*loaded(file), name), 1u) << name;
    }
    GltfFile used = quadAlone();
    used.json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_node_hoverability", "VENDOR_x"};
    EXPECT_EQ(notesWith(*loaded(used), "KHR_node_hoverability, VENDOR_x"), 1u);
    EXPECT_EQ(notesWith(*loaded(used), "KHR_lights_punctual"), 0u);
    for (const char* name : {"KHR_node_visibility", "KHR_meshopt_compression"}) {
        GltfFile file = quadAlone();
        file.json["extensionsRequired"] = Json::array({name});
        EXPECT_NE(refusal(file).find(name), std::string::npos) << name;
    }
}

TEST(Extensions, CompressionIsNamedEvenWhereItIsNotRequired) {
    GltfFile draco = quadAlone();
    draco.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    Json& primitive = draco.json["meshes"][0]["primitives"][0];
    primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
    EXPECT_EQ(refusal(draco), "");  // it is there uncompressed too
    for (Json& accessor : draco.json["accessors"]) accessor.erase("bufferView");
    EXPECT_NE(refusal(draco).find("KHR_draco_mesh_compression"), std::string::npos) << refusal(draco);

    GltfFile meshopt = quadAlone();
    meshopt.json["extensionsUsed"] = {"KHR_meshopt_compression"};
    meshopt.json["buffers"] =
        Json::array({{{"byteLength", meshopt.data.size()}},
                     {{"byteLength", 100}, {"extensions", {{"KHR_meshopt_compression", {{"fallback", true}}}}}}});
    EXPECT_NE(refusal(meshopt).find("compressed with KHR_meshopt_compression"), std::string::npos) << refusal(meshopt);
}

TEST(Extensions, AnimatedPropertiesThatAreLeftOutAreNamed) {
    GltfFile file = quadAlone();
    file.animate(0, "translation", {0, 1}, file.vec3s({0, 0, 0, 1, 0, 0}));
    Json& animation = file.json["animations"][0];
    for (const char* what : {"/materials/0/emissiveFactor", "/nodes/0/extensions/KHR_node_visibility/visible",
                             "/cameras/0/perspective/yfov"})
        animation["channels"].push_back(
            {{"sampler", 0},
             {"target", {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", what}}}}}}}});
    file.json["extensionsUsed"] = {"KHR_animation_pointer"};
    const auto scene = loaded(file);
    EXPECT_EQ(notesWith(*scene, "3 animated properties are left out (KHR_animation_pointer)"), 1u);
    for (const char* what : {"emissiveFactor", "KHR_node_visibility", "yfov"}) EXPECT_EQ(notesWith(*scene, what), 1u);
    EXPECT_DOUBLE_EQ(scene->duration(), 1.0);
}

TEST(LeftOut, UnknownLightsAndRootsThatAreChildren) {
    GltfFile light = quadAlone();
    light.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({{{"type", "area"}, {"name", "panel"}}});
    light.addRoot({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    EXPECT_EQ(notesWith(*loaded(light), "light \"panel\" has the type \"area\""), 1u);

    GltfFile root = quadAlone();
    root.addRoot({{"children", {0}}, {"translation", {2, 0, 0}}});
    const auto scene = loaded(root);
    EXPECT_EQ(notesWith(*scene, "roots of the scene and children too"), 1u);
    EXPECT_NEAR(scene->bounds().low.x, 2.0, 1e-12);
}

TEST(Refused, TwoParentsAndJointsWithoutWeights) {
    GltfFile parents = quadAlone();
    parents.addRoot({{"children", {0}}});
    parents.addRoot({{"children", {0}}});
    EXPECT_NE(refusal(parents).find("node 0 has two parents"), std::string::npos) << refusal(parents);
    for (const auto& [one, other] :
         {std::pair{"JOINTS_0", "WEIGHTS_0"}, {"WEIGHTS_0", "JOINTS_0"}, {"JOINTS_1", "WEIGHTS_1"}}) {
        GltfFile file = quadAlone();
        file.json["meshes"][0]["primitives"][0]["attributes"][one] =
            file.addAccessor<std::uint8_t>(std::vector<std::uint8_t>(16, 0), "VEC4", 4);
        EXPECT_NE(refusal(file).find(std::string(one) + " without " + other), std::string::npos) << refusal(file);
    }
}

}  // namespace
}  // namespace timeshade
