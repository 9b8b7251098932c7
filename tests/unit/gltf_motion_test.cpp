// Clips, shutters, cameras and lights: small files with known results.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "../broken_gltf/loaded.h"

namespace timeshade {
namespace {

using namespace test;
constexpr double half = 0.70710678118654752;

GltfFile movingQuad() {
    GltfFile file;
    addQuad(file);
    file.addRoot({{"mesh", 0}});
    return file;
}

/// The x of the quad's first corner at a time.
double cornerAt(const Scene& scene, double seconds) { return scene.motionMesh(seconds, seconds).positionsOpen[0].x; }

TEST(GltfMotion, LinearStepAndSplineTranslations) {
    GltfFile linear = movingQuad();
    linear.animate(0, "translation", {1, 3}, linear.vec3s({2, 0, 0, 6, 0, 0}));
    const auto line = loaded(linear);
    EXPECT_DOUBLE_EQ(line->duration(), 3.0);
    EXPECT_DOUBLE_EQ(cornerAt(*line, 0.5), 2.0);  // held before the first key
    EXPECT_DOUBLE_EQ(cornerAt(*line, 1.5), 3.0);

    GltfFile step = movingQuad();
    step.animate(0, "translation", {0, 1, 2}, step.vec3s({2, 0, 0, 6, 0, 0, 7, 0, 0}), "STEP");
    EXPECT_DOUBLE_EQ(cornerAt(*loaded(step), 0.999), 2.0);
    EXPECT_DOUBLE_EQ(cornerAt(*loaded(step), 1.0), 6.0);

    GltfFile spline = movingQuad();  // in-tangent, value, out-tangent per key
    spline.animate(0, "translation", {0, 2}, spline.vec3s({0, 0, 0, 1, 0, 0, 3, 0, 0, -1, 0, 0, 5, 0, 0, 0, 0, 0}),
                   "CUBICSPLINE");
    // Hermite at t = 1/4 of a segment of 2 s: value 1 to 5, tangents 3 and -1 per second.
    const double t = 0.25, t2 = t * t, t3 = t2 * t;
    const double expected =
        (2 * t3 - 3 * t2 + 1) * 1 + 2 * (t3 - 2 * t2 + t) * 3 + (3 * t2 - 2 * t3) * 5 + 2 * (t3 - t2) * -1;
    EXPECT_NEAR(cornerAt(*loaded(spline), 0.5), expected, 1e-12);
}

TEST(GltfMotion, RotationsTakeTheShorterWayAtConstantSpeed) {
    GltfFile file = movingQuad();
    // From 0 to 90 degrees about z; the second quaternion is negated, which is the same turn seen the long way round.
    file.animate(0, "rotation", {0, 1}, file.vec4s({0, 0, 0, 1, 0, 0, -0.70710678f, -0.70710678f}));
    const auto scene = loaded(file);
    const MotionMesh mesh = scene->motionMesh(0.2, 0.4);
    EXPECT_NEAR(std::atan2(mesh.positionsOpen[1].y, mesh.positionsOpen[1].x), 0.2 * 1.5707963267948966, 1e-6);
    EXPECT_NEAR(mesh.largestTurnDegrees, 18.0, 1e-5);
}

TEST(GltfMotion, NormalisedIntegerRotationsAndMorphWeights) {
    GltfFile file = movingQuad();
    file.json["meshes"][0]["primitives"][0]["targets"] =
        Json::array({{{"POSITION", file.vec3s(std::vector<float>(12, 1.0f))}}});
    file.animate(0, "rotation", {0, 1},
                 file.addAccessor<std::int16_t>({0, 0, 0, 32767, 0, 0, 32767, 0}, "VEC4", 4, true));
    file.animate(0, "weights", {0, 1}, file.addAccessor<std::uint8_t>({0, 0, 0, 255}, "SCALAR", 1, true));
    file.json["accessors"].back()["count"] = 2;
    file.json["animations"][0]["samplers"][1]["output"] = file.addAccessor<std::uint8_t>({0, 255}, "SCALAR", 1, true);
    const auto scene = loaded(file);
    const MotionMesh mesh = scene->motionMesh(0.0, 0.5);
    EXPECT_NEAR(mesh.positionsOpen[1].x, 1.0, 1e-6);
    EXPECT_NEAR(mesh.positionsClose[1].x, -0.5, 1e-6);  // (1,0) + 0.5, turned by 90 degrees
    EXPECT_NEAR(mesh.positionsClose[1].y, 1.5, 1e-6);
}

TEST(GltfMotion, StaticVerticesAreStaticToTheLastBit) {
    GltfFile file = movingQuad();
    file.addRoot({{"mesh", 0}, {"translation", {0.1, 0.2, 0.3}}});
    file.animate(0, "translation", {0, 1, 2}, file.vec3s({0.1f, 0.3f, 0.7f, 0.1f, 0.3f, 0.7f, 5, 0, 0}));
    file.animate(0, "rotation", {0, 1, 2}, file.vec4s({0.1f, 0.2f, 0.3f, 0.9f, 0.1f, 0.2f, 0.3f, 0.9f, 0, 0, 0, 1}));
    const MotionMesh mesh = loaded(file)->motionMesh(0.123, 0.789);
    EXPECT_EQ(mesh.positionsOpen, mesh.positionsClose);
    EXPECT_EQ(mesh.largestTurnDegrees, 0.0);
}

TEST(GltfMotion, AClipThatDoesNotLoopIsHeldAtItsEnds) {
    GltfFile file = movingQuad();
    file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}});
    file.addRoot({{"camera", 0}});
    file.animate(0, "translation", {0, 1}, file.vec3s({0, 0, 0, 10, 0, 0}));
    file.animate(1, "translation", {0, 1}, file.vec3s({0, 0, 5, 10, 0, 5}));
    const auto scene = loaded(file);
    const MotionMesh mesh = scene->motionMesh(0.9, 1.1);
    EXPECT_NEAR(mesh.positionsOpen[0].x, 9.0, 1e-6);
    EXPECT_NEAR(mesh.positionsClose[0].x, 10.0, 1e-6);
    EXPECT_NEAR(scene->cameraEnds(0, 0.9, 1.1).close.eye.x, 10.0, 1e-6);
    EXPECT_NEAR(scene->cameraEnds(0, 0.2, 0.3).close.eye.x, 3.0, 1e-6);
    EXPECT_NEAR(cornerAt(*scene, 1.25), 10.0, 1e-6);
    EXPECT_NEAR(cornerAt(*scene, -0.75), 0.0, 1e-6);
    EXPECT_NEAR(scene->cameraEnds(0, 7.9, 8.1).open.eye.x, 10.0, 1e-6);
    EXPECT_FALSE(scene->loops());
}

TEST(GltfMotion, AClipThatLoopsGoesOnThroughItsEnd) {
    GltfFile file = movingQuad();
    file.animate(0, "translation", {0, 1, 2}, file.vec3s({0, 0, 0, 10, 0, 0, 0, 0, 0}));
    const auto scene = loaded(file);
    const MotionMesh mesh = scene->motionMesh(1.9, 2.2);
    EXPECT_NEAR(mesh.positionsOpen[0].x, 1.0, 1e-6);
    EXPECT_NEAR(mesh.positionsClose[0].x, 2.0, 1e-6);
    EXPECT_TRUE(scene->loops());
    EXPECT_NEAR(scene->bounds().high.x, 11.0, 1e-6);
}

TEST(GltfMotion, AWholeTurnInOneShutterIsNoticed) {
    GltfFile file = movingQuad();
    const float h = 0.70710678f;
    file.animate(0, "rotation", {0, 1, 2, 3, 4},
                 file.vec4s({0, 0, 0, 1, 0, 0, h, h, 0, 0, 1, 0, 0, 0, h, -h, 0, 0, 0, -1}));
    EXPECT_NEAR(loaded(file)->motionMesh(0, 4).largestTurnDegrees, 360.0, 1e-3);
}

TEST(GltfMotion, ClipsByName) {
    GltfFile file = movingQuad();
    file.animate(0, "translation", {0, 1}, file.vec3s({1, 0, 0, 1, 0, 0}));
    file.json["animations"][0]["name"] = "one";
    Json second = file.json["animations"][0];
    second["name"] = "two";
    second["samplers"][0]["output"] = file.vec3s({2, 0, 0, 2, 0, 0});
    file.json["animations"].push_back(second);
    EXPECT_DOUBLE_EQ(cornerAt(*loaded(file), 0.5), 1.0);
    EXPECT_DOUBLE_EQ(cornerAt(*loaded(file, {.clip = "two"}), 0.5), 2.0);
    EXPECT_THROW(loaded(file, {.clip = "three"}), Error);
    EXPECT_EQ(loaded(file)->clips(), (std::vector<std::string>{"one", "two"}));
    EXPECT_EQ(loaded(file)->clip(), 0u);
    EXPECT_EQ(loaded(file, {.clip = "two"})->clip(), 1u);
}

TEST(GltfMotion, ClipsOfOneNameCanBeToldApart) {
    GltfFile file = movingQuad();
    file.animate(0, "translation", {0, 1}, file.vec3s({1, 0, 0, 1, 0, 0}));
    for (const char* name : {"walk", "walk (2)", "walk"}) {
        file.json["animations"].push_back(file.json["animations"][0]);
        file.json["animations"].back()["name"] = name;
    }
    file.json["animations"][0].erase("name");
    file.json["animations"][3]["samplers"][0]["output"] = file.vec3s({4, 0, 0, 4, 0, 0});
    EXPECT_EQ(loaded(file)->clips(), (std::vector<std::string>{"animation_0", "walk", "walk (2)", "walk (3)"}));
    EXPECT_DOUBLE_EQ(cornerAt(*loaded(file, {.clip = "walk (3)"}), 0.5), 4.0);
}

TEST(GltfMotion, AnimatedMatrixNodesAreTakenApart) {
    GltfFile file;
    addQuad(file);
    file.addRoot({{"mesh", 0},
                  {"matrix", {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 7, 0, 0, 1}}});  // twice the size, a quarter turn
    file.animate(0, "translation", {0, 1}, file.vec3s({1, 0, 0, 1, 0, 0}));
    const auto scene = loaded(file);
    const MotionMesh mesh = scene->motionMesh(0, 0);
    EXPECT_NEAR(mesh.positionsOpen[1].x, 1.0, 1e-12);
    EXPECT_NEAR(mesh.positionsOpen[1].y, 2.0, 1e-12);
    EXPECT_GE(notesWith(*scene, "given as matrices"), 1u);
}

TEST(GltfViews, CamerasLookAlongMinusZAndHaveDifferentNames) {
    GltfFile file = movingQuad();
    file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.25}}}});
    file.add("cameras",
             {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 10}, {"znear", 0.1}}}});
    file.addRoot({{"name", "eye"}, {"camera", 0}, {"translation", {0, 0, 4}}, {"scale", {3, 3, 3}}});
    file.addRoot(
        {{"name", "eye"}, {"camera", 0}, {"rotation", {0, half, 0, half}}});  // a quarter turn about y: looks along -x
    file.addRoot({{"name", "flat"}, {"camera", 1}});
    const auto scene = loaded(file);
    ASSERT_EQ(scene->cameras().size(), 2u);
    EXPECT_EQ(scene->cameras()[0].name, "eye");
    EXPECT_EQ(scene->cameras()[1].name, "eye 2");
    EXPECT_GE(notesWith(*scene, "\"flat\" is orthographic"), 1u);
    const CameraPose pose = scene->camera(0, 0);
    EXPECT_DOUBLE_EQ(pose.eye.z, 4.0);
    EXPECT_DOUBLE_EQ(pose.nearDistance, 0.25);
    EXPECT_DOUBLE_EQ(pose.verticalFieldOfView, 0.7);
    EXPECT_LE(glm::length(pose.axes[2] - glm::dvec3(0, 0, 1)), 1e-12);
    EXPECT_LE(glm::length(scene->camera(1, 0).axes[2] - glm::dvec3(1, 0, 0)), 1e-12);
}

/// A file with lights of the given kinds, one node each, at (i, 3, 0).
GltfFile fileWithLights(const Json& lights) {
    GltfFile file = movingQuad();
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = lights;
    for (std::size_t i = 0; i < lights.size(); ++i)
        file.addRoot({{"name", "lamp " + std::to_string(i)},
                      {"translation", {i, 3, 0}},
                      {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
    return file;
}

TEST(GltfViews, TheFirstUsableLightShines) {
    const Json point = {{"type", "point"}, {"intensity", 5}};
    const Json dark = {{"type", "spot"}, {"intensity", 0}, {"spot", Json::object()}};
    const Json spot = {{"type", "spot"},
                       {"intensity", 50},
                       {"color", {1, 0.5, 0}},
                       {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}};
    const auto scene = loaded(fileWithLights({point, dark, spot, spot}));
    const LightPose light = scene->light(0);
    EXPECT_EQ(light.kind, LightKind::Spot);
    EXPECT_DOUBLE_EQ(light.position.x, 2.0);
    EXPECT_DOUBLE_EQ(light.intensity.y, 25.0);
    EXPECT_DOUBLE_EQ(light.innerConeAngle, 0.2);
    EXPECT_DOUBLE_EQ(light.outerConeAngle, 0.4);
    EXPECT_GE(notesWith(*scene, "3 left out: lamp 0, lamp 1, lamp 3"), 1u);
}

TEST(GltfViews, AnotherLightIsChosenByNameOrNumber) {
    const Json point = {{"type", "point"}, {"intensity", 5}};
    const Json dark = {{"type", "spot"}, {"intensity", 0}, {"spot", Json::object()}};
    const Json spot = {{"type", "spot"}, {"intensity", 50}, {"spot", Json::object()}};
    const GltfFile file = fileWithLights({point, dark, spot, spot});
    const auto chosen = [&](const std::string& name) { return loaded(file, {.light = name}); };
    EXPECT_EQ(loaded(file)->lights(), (std::vector<std::string>{"lamp 0", "lamp 2", "lamp 3"}));
    EXPECT_EQ(loaded(file)->chosenLight(), 1u);
    for (const char* name : {"lamp 3", "3"}) {
        EXPECT_DOUBLE_EQ(chosen(name)->light(0).position.x, 3.0) << name;
        EXPECT_EQ(chosen(name)->chosenLight(), 2u);
        EXPECT_EQ(notesWith(*chosen(name), "3 left out: lamp 0, lamp 1, lamp 2"), 1u);
    }
    EXPECT_NE(chosen("3")->contentDigest(), loaded(file)->contentDigest());
    EXPECT_EQ(chosen("fitted")->chosenLight(), 3u);
    EXPECT_LT(chosen("fitted")->light(0).position.y, 3.0);
    for (const char* name : {"lamp 1", "0", "4", "lamp"})
        EXPECT_NE(refusal(file, {.light = name}).find("it has: lamp 0, lamp 2, lamp 3"), std::string::npos) << name;
}

TEST(GltfViews, SunsPointLightsAndWideSpots) {
    const auto sun = loaded(fileWithLights({{{"type", "directional"}}}));
    EXPECT_EQ(sun->light(0).kind, LightKind::Directional);

    const auto bulb = loaded(fileWithLights({{{"type", "point"}, {"intensity", 5}}}));
    const LightPose light = bulb->light(0);
    EXPECT_NEAR(light.outerConeAngle, 80.0 * 3.14159265358979 / 180.0, 1e-3);
    const glm::dvec3 towards = glm::normalize(bulb->bounds().centre() - light.position);
    EXPECT_LE(glm::length(light.axes[2] + towards), 1e-12);
    EXPECT_GE(notesWith(*bulb, "point light \"lamp 0\""), 1u);

    const auto wide = loaded(
        fileWithLights({{{"type", "spot"}, {"spot", {{"innerConeAngle", 2.0}, {"outerConeAngle", 1.5707963}}}}}));
    EXPECT_DOUBLE_EQ(wide->light(0).outerConeAngle, 1.48);
    EXPECT_LT(wide->light(0).innerConeAngle, wide->light(0).outerConeAngle);
}

TEST(GltfDefaults, ComeFromTheScenesExtras) {
    GltfFile file = movingQuad();
    file.animate(0, "translation", {0, 3}, file.vec3s({0, 0, 0, 10, 0, 0}));
    EXPECT_DOUBLE_EQ(loaded(file)->defaults().frame, 24.0);  // a third of three seconds at 24 frames a second

    file.json["scenes"][0]["extras"]["timeshade"] = {{"frame", 7}, {"fps", 30}, {"shutter", 0.75}};
    const SceneDefaults given = loaded(file)->defaults();
    EXPECT_DOUBLE_EQ(given.frame, 7.0);
    EXPECT_DOUBLE_EQ(given.framesPerSecond, 30.0);
    EXPECT_DOUBLE_EQ(given.shutterLength, 0.75);

    file.json["scenes"][0]["extras"]["timeshade"] = {{"frame", "seven"}, {"fps", 0}, {"shutter", -1}};
    const auto scene = loaded(file);
    EXPECT_DOUBLE_EQ(scene->defaults().framesPerSecond, 24.0);
    EXPECT_DOUBLE_EQ(scene->defaults().shutterLength, 0.5);
    EXPECT_GE(notesWith(*scene, "extras.timeshade.fps"), 1u);

    file.json["scenes"][0]["extras"]["timeshade"] = 5;
    EXPECT_GE(notesWith(*loaded(file), "extras.timeshade is not an object"), 1u);
}

}  // namespace
}  // namespace timeshade
