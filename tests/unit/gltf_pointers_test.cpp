// KHR_animation_pointer: what it drives of nodes and lights, against the values that the keys say.

#include <gtest/gtest.h>

#include "../broken_gltf/loaded.h"

namespace timeshade {
namespace {

using namespace test;

/// A quad, and one light of the given type on a node above it.
GltfFile litQuad(const char* type) {
    GltfFile file;
    addQuad(file);
    file.addRoot({{"mesh", 0}});
    Json light = {{"type", type}, {"name", "lamp"}, {"intensity", 100}, {"color", {1, 0.5, 0.25}}};
    if (std::string(type) == "spot") light["spot"] = {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.5}};
    file.json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_animation_pointer"};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({light});
    file.addRoot({{"translation", {0.5, 0.5, 4}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return file;
}

void drive(GltfFile& file, const std::string& pointer, const std::vector<float>& times, int output,
           const char* interpolation = "LINEAR") {
    file.animate(0, "translation", times, output, interpolation);
    file.json["animations"][0]["channels"].back()["target"] = {
        {"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}};
}

const std::string lamp = "/extensions/KHR_lights_punctual/lights/0/";

TEST(AnimationPointer, DrivesALightsIntensityColourRangeAndCone) {
    GltfFile file = litQuad("spot");
    drive(file, lamp + "intensity", {0, 2}, file.scalars({100, 300}));
    drive(file, lamp + "color", {0, 1, 2}, file.vec3s({1, 1, 1, 0.5f, 1, 0, 1, 1, 1}));
    drive(file, lamp + "range", {0, 2}, file.scalars({10, 20}));
    drive(file, lamp + "spot/innerConeAngle", {0, 2}, file.scalars({0.1f, 0.3f}));
    drive(file, lamp + "spot/outerConeAngle", {0, 2}, file.scalars({0.4f, 0.8f}), "STEP");
    const auto scene = loaded(file);
    EXPECT_DOUBLE_EQ(scene->duration(), 2.0);
    EXPECT_FALSE(scene->loops());
    const LightPose early = scene->light(0.5), late = scene->light(2.0);
    EXPECT_NEAR(early.intensity.x, 150 * 0.75, 1e-4);
    EXPECT_NEAR(early.intensity.z, 150 * 0.5, 1e-4);
    EXPECT_NEAR(early.range, 12.5, 1e-5);
    EXPECT_NEAR(early.innerConeAngle, 0.15, 1e-6);
    EXPECT_NEAR(early.outerConeAngle, 0.4, 1e-6);
    EXPECT_NEAR(late.intensity.x, 300, 1e-4);
    EXPECT_NEAR(late.outerConeAngle, 0.8, 1e-6);
    EXPECT_EQ(notesWith(*scene, "animated intensity, colour, range or cone"), 1u);
    EXPECT_EQ(scene->notes().size(), 1u);

    // All of a shutter have the middle's: of a linear change the mean.
    const auto ends = scene->lightEnds(0.25, 0.75);
    EXPECT_EQ(ends.open.intensity, ends.close.intensity);
    EXPECT_NEAR(ends.open.intensity.x, early.intensity.x, 1e-9);
    EXPECT_EQ(ends.open.outerConeAngle, ends.close.outerConeAngle);
}

TEST(AnimationPointer, ValuesAreHeldToWhatALightCanHave) {
    GltfFile file = litQuad("spot");
    drive(file, lamp + "intensity", {0, 1}, file.scalars({-5, 10}));
    drive(file, lamp + "spot/innerConeAngle", {0, 1}, file.scalars({2, 2}));
    drive(file, lamp + "spot/outerConeAngle", {0, 1}, file.scalars({-1, 3}));
    const auto scene = loaded(file);
    EXPECT_EQ(notesWith(*scene, "opens wider than"), 1u);
    for (double t = 0.0; t <= 1.0; t += 0.125) {
        const LightPose pose = scene->light(t);
        EXPECT_GE(pose.intensity.x, 0.0);
        EXPECT_GT(pose.outerConeAngle, 1e-3);
        EXPECT_LE(pose.outerConeAngle, 1.48);
        EXPECT_LT(pose.innerConeAngle, pose.outerConeAngle);
    }
}

TEST(AnimationPointer, ALightThatIsDarkAtRestIsTheLight) {
    for (const char* type : {"spot", "directional", "point"}) {
        GltfFile file = litQuad(type);
        file.json["extensions"]["KHR_lights_punctual"]["lights"][0]["intensity"] = 0;
        EXPECT_EQ(notesWith(*loaded(file), "1 left out: lamp"), 1u);
        drive(file, lamp + "intensity", {0, 1}, file.scalars({0, 50}));
        const auto scene = loaded(file);
        EXPECT_EQ(notesWith(*scene, "left out"), 0u);
        EXPECT_NEAR(scene->light(1.0).intensity.x, 50.0, 1e-5);
    }
}

TEST(AnimationPointer, DrivesNodesAsOrdinaryChannelsDo) {
    for (const auto& [path, width] : {std::pair{"translation", 3}, {"rotation", 4}, {"scale", 3}}) {
        std::vector<float> values(static_cast<std::size_t>(2 * width), 0.5f);
        values[0] = 2.0f;
        GltfFile pointed = litQuad("spot"), ordinary = litQuad("spot");
        for (GltfFile* file : {&pointed, &ordinary}) {
            const int output = width == 3 ? file->vec3s(values) : file->vec4s(values);
            if (file == &pointed)
                drive(*file, std::string("/nodes/0/") + path, {0, 1}, output);
            else
                file->animate(0, path, {0, 1}, output);
        }
        const auto a = loaded(pointed), b = loaded(ordinary);
        EXPECT_EQ(a->notes(), b->notes());
        for (const double t : {0.0, 0.3, 1.0})
            EXPECT_EQ(a->motionMesh(t, t).positionsOpen, b->motionMesh(t, t).positionsOpen) << path << " " << t;
    }
}

TEST(AnimationPointer, WhatItCannotDriveIsNamed) {
    for (const std::string& pointer : std::vector<std::string>{
             "/materials/0/emissiveFactor", lamp + "spot", lamp + "intensity/x", "/nodes//translation",
             "/nodes/-1/scale", "/nodes/0x/scale", "/extensions/KHR_lights_punctual/lights/intensity", ""}) {
        GltfFile file = litQuad("spot");
        drive(file, pointer, {0, 1}, file.scalars({1, 2}));
        EXPECT_EQ(notesWith(*loaded(file), "1 animated property is left out (KHR_animation_pointer)"), 1u) << pointer;
    }
    GltfFile light = litQuad("spot"), node = litQuad("spot"), shape = litQuad("spot");
    drive(light, "/extensions/KHR_lights_punctual/lights/3/intensity", {0, 1}, light.scalars({1, 2}));
    EXPECT_NE(refusal(light).find("light 3"), std::string::npos) << refusal(light);
    drive(node, "/nodes/12/scale", {0, 1}, node.vec3s({1, 1, 1, 2, 2, 2}));
    EXPECT_NE(refusal(node).find("node 12"), std::string::npos) << refusal(node);
    drive(shape, lamp + "intensity", {0, 1}, shape.vec3s({1, 1, 1, 2, 2, 2}));
    EXPECT_NE(refusal(shape).find("animation 0 (light 0)"), std::string::npos) << refusal(shape);
}

}  // namespace
}  // namespace timeshade
