// What the motion of a frame leaves out is said, with its size: keys inside the shutter, turns, bones, morph weights,
// cameras, lights, jumps.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <regex>

#include <gtest/gtest.h>
#include <timeshade/paths.h>

#include "../broken_gltf/gltf_writer.h"
#include "plan/frame_plan.h"
#include "scene/gltf_scene.h"
#include "scene/inner_motion.h"

namespace timeshade {
namespace {

using namespace test;

/// A camera at (0, 0, 10) that looks at the origin through 100 x 100 pixels, a field of 90 degrees: at z = 0 a unit of
/// length has 5 pixels. A sun behind it, whose map is fitted to a wall of 16 x 16 units at z = -1.
GltfFile stage() {
    GltfFile file;
    addQuad(file);
    file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.57079632679}, {"znear", 0.1}}}});
    file.json["extensionsUsed"] = {"KHR_lights_punctual"};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({{{"type", "directional"}}});
    file.addRoot({{"name", "thing"}, {"mesh", 0}});
    file.addRoot({{"mesh", 0}, {"scale", {16, 16, 1}}, {"translation", {-8, -8, -1}}});
    file.addRoot({{"name", "eye"}, {"camera", 0}, {"translation", {0, 0, 10}}});
    file.addRoot({{"name", "sun"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return file;
}

FrameRequest requestOf(double frame, double length) {
    FrameRequest request;
    request.width = request.height = 100;
    request.mapSize = 160;
    request.frame = frame;
    request.shutter.framesPerSecond = 1.0;
    request.shutter.length = length;
    return request;
}

std::vector<std::string> warningsOf(const GltfFile& file, double frame, double length) {
    const TemporaryFolder folder;
    const auto scene = loadGltf(folder.write("test.glb", file.glb()));
    return FramePlanner(*scene).plan(requestOf(frame, length)).warnings;
}

/// The number before " pixels" in the one warning that there is.
double pixelsIn(const std::vector<std::string>& warnings, const std::string& mentions) {
    EXPECT_EQ(warnings.size(), 1u);
    if (warnings.size() != 1) return -1.0;
    EXPECT_NE(warnings[0].find(mentions), std::string::npos) << warnings[0];
    std::smatch found;
    if (!std::regex_search(warnings[0], found, std::regex("([0-9.]+) pixels"))) return -1.0;
    return std::stod(found[1]);
}

TEST(PathWarnings, OutAndBackStandsStillAndIsSaid) {
    GltfFile file = stage();
    file.animate(0, "translation", {0, 0.5f, 1}, file.vec3s({0, 0, 0, 4, 0, 0, 0, 0, 0}));
    EXPECT_NEAR(pixelsIn(warningsOf(file, 0, 1), "\"thing\" leaves the straight path"), 20.0, 0.1);
    // A key that is none of the three instants that are always looked at.
    GltfFile early = stage();
    early.animate(0, "translation", {0, 0.1f, 1}, early.vec3s({0, 0, 0, 4, 0, 0, 0, 0, 0}));
    EXPECT_NEAR(pixelsIn(warningsOf(early, 0, 1), "u = 0.1"), 20.0, 0.1);
    EXPECT_EQ(warningsOf(file, 0, 0.5).size(), 0u);  // straight
    EXPECT_EQ(warningsOf(file, 0, 0.0).size(), 0u);
}

TEST(PathWarnings, LessThanHalfAPixelIsNotSaid) {
    for (const auto& [way, warnings] : {std::pair{0.02f, 0u}, {0.3f, 1u}}) {
        GltfFile file = stage();
        file.animate(0, "translation", {0, 0.5f, 1}, file.vec3s({0, 0, 0, way, 0, 0, 0, 0, 0}));
        EXPECT_EQ(warningsOf(file, 0, 1).size(), warnings) << way;
    }
}

TEST(PathWarnings, TurnsAreMeasuredAlike) {
    GltfFile file = stage();
    const auto turn = [&](double degrees) {
        return file.vec4s({0, 0, 0, 1, 0, 0, static_cast<float>(std::sin(0.5 * glm::radians(degrees))),
                           static_cast<float>(std::cos(0.5 * glm::radians(degrees)))});
    };
    GltfFile half = file;
    half.animate(0, "rotation", {0, 1}, half.vec4s({0, 0, 0, 1, 0, 0, 1, 0}));
    // The corner (1, 1) goes round, while its straight path passes through the centre.
    const std::vector<std::string> warnings = warningsOf(half, 0, 1);
    EXPECT_NEAR(pixelsIn(warnings, "turns by 180 degrees"), std::sqrt(2.0) * 5.0, 0.1);
    file.animate(0, "rotation", {0, 1}, turn(5.0));
    EXPECT_EQ(warningsOf(file, 0, 1).size(), 0u);
}

TEST(PathWarnings, OfBonesAndMorphWeights) {
    GltfFile bone = stage();
    const int joints = bone.addAccessor<std::uint8_t>(std::vector<std::uint8_t>(16, 0), "VEC4", 4);
    const int weights = bone.vec4s({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    bone.json["meshes"].push_back(bone.json["meshes"][0]);
    bone.json["meshes"][1]["primitives"][0]["attributes"]["JOINTS_0"] = joints;
    bone.json["meshes"][1]["primitives"][0]["attributes"]["WEIGHTS_0"] = weights;
    bone.json["nodes"][0]["mesh"] = 1;
    bone.json["nodes"][0]["skin"] = 0;
    const int joint = bone.addRoot({{"name", "joint"}});
    bone.add("skins", {{"joints", {joint}}});
    bone.animate(joint, "translation", {0, 0.5f, 1}, bone.vec3s({0, 0, 0, 0, 2, 0, 0, 0, 0}));
    EXPECT_NEAR(pixelsIn(warningsOf(bone, 0, 1), "\"thing\" leaves"), 10.0, 0.1);

    GltfFile morph = stage();
    morph.json["meshes"].push_back(morph.json["meshes"][0]);
    morph.json["meshes"][1]["primitives"][0]["targets"] =
        Json::array({{{"POSITION", morph.vec3s({0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0})}}});
    morph.json["nodes"][0]["mesh"] = 1;
    morph.animate(0, "weights", {0, 0.25f, 1}, morph.scalars({0, 1, 0}));
    EXPECT_NEAR(pixelsIn(warningsOf(morph, 0, 1), "u = 0.25"), 15.0, 0.1);
}

TEST(PathWarnings, OfCamerasAndLights) {
    GltfFile camera = stage();
    camera.animate(2, "translation", {0, 0.5f, 1}, camera.vec3s({0, 0, 10, 1, 0, 10, 0, 0, 10}));
    EXPECT_NEAR(pixelsIn(warningsOf(camera, 0, 1), "the camera leaves"), 5.0, 0.6);

    GltfFile cut = stage();
    cut.animate(2, "translation", {0, 0.25f, 1}, cut.vec3s({0, 0, 10, 2, 0, 10, 2, 0, 10}), "STEP");
    EXPECT_GT(pixelsIn(warningsOf(cut, 0, 1), "the camera cuts inside the shutter"), 8.0);
    EXPECT_EQ(warningsOf(cut, 0.25, 0.5).size(), 0u);  // the key is the shutter's opening

    GltfFile sun = stage();
    sun.animate(3, "rotation", {0, 0.5f, 1}, sun.vec4s({0, 0, 0, 1, 0, 0.1f, 0, 0.995f, 0, 0, 0, 1}));
    const std::vector<std::string> warnings = warningsOf(sun, 0, 1);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("the light leaves"), std::string::npos) << warnings[0];
}

TEST(PathWarnings, JumpsAreSaidApart) {
    GltfFile file = stage();
    file.animate(0, "translation", {0, 0.3f, 1}, file.vec3s({0, 0, 0, 4, 0, 0, 4, 0, 0}), "STEP");
    EXPECT_NEAR(pixelsIn(warningsOf(file, 0, 1), "\"thing\" jumps inside the shutter"), 20.0, 0.1);
    EXPECT_EQ(warningsOf(file, 0.3, 0.5).size(), 0u);
    EXPECT_EQ(warningsOf(file, 0.0, 0.3).size(), 0u);  // the key is the shutter's closing
}

TEST(InnerInstants, AreThreeAndTheKeys) {
    EXPECT_EQ(innerInstants({}), (std::vector<double>{0.25, 0.5, 0.75}));
    EXPECT_EQ(innerInstants({0.9, 0.5, -1.0, 0.0, 1.0, 0.1, 0.9}), (std::vector<double>{0.1, 0.25, 0.5, 0.75, 0.9}));
    std::vector<double> many;
    for (int i = 1; i < 5000; ++i) many.push_back(i / 5000.0);
    const std::vector<double> few = innerInstants(many);
    EXPECT_LE(few.size(), mostInnerInstants);
    EXPECT_GE(few.size(), mostInnerInstants - 3);
    EXPECT_LT(few.front(), 0.02);
    EXPECT_GT(few.back(), 0.97);
}

/// A loop over the keys of a mocap clip inside a long shutter ends, and what it looks at is bounded.
TEST(InnerMotion, OfManyKeysIsBounded) {
    GltfFile file = stage();
    std::vector<float> times, places;
    for (int i = 0; i <= 20'000; ++i) {
        times.push_back(static_cast<float>(i) / 1000.0f);
        places.insert(places.end(), {static_cast<float>(i % 2), 0.0f, 0.0f});
    }
    file.animate(0, "translation", times, file.vec3s(places));
    const TemporaryFolder folder;
    const auto scene = loadGltf(folder.write("test.glb", file.glb()));
    EXPECT_LE(scene->innerMotion(0.0, 16.0).instants.size(), mostInnerInstants + 1);
}

/// The best of several runs, since the machine does other things too.
TEST(InnerMotion, CostsAtMostAMillisecondOnChess) {
    const auto scene = loadGltf(std::filesystem::path(TIMESHADE_SOURCE_DIRECTORY) / "assets/scenes/chess.glb");
    const double open = scene->defaults().frame / scene->defaults().framesPerSecond;
    double best = 1e9;
    for (int run = 0; run < 50; ++run) {
        const auto start = std::chrono::steady_clock::now();
        const InnerMotion inner = scene->innerMotion(open, open + 0.5 / 24.0);
        best =
            std::min(best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        EXPECT_FALSE(inner.groups.empty());
    }
    EXPECT_LE(best, 1.0);
}

}  // namespace
}  // namespace timeshade
