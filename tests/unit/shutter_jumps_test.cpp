// Jumps inside a shutter are never smeared, and a clip's ends are held or repeat: STEP keys of nodes, parents, bones,
// morph weights, cameras and lights.

#include <cmath>

#include <gtest/gtest.h>

#include "../broken_gltf/loaded.h"
#include "plan/frame_plan.h"

namespace timeshade {
namespace {

using namespace test;

/// The x of the first corner at both ends of a frame's shutter.
struct Ends {
    double open, close;
};

FrameRequest requestOf(double frame, double framesPerSecond, double length,
                       ShutterPosition position = ShutterPosition::Start) {
    FrameRequest request;
    request.width = 64;
    request.height = 48;
    request.mapSize = 64;
    request.frame = frame;
    request.shutter.framesPerSecond = framesPerSecond;
    request.shutter.length = length;
    request.shutter.position = position;
    return request;
}

Ends endsOf(const Scene& scene, const FrameRequest& request) {
    const FramePlan plan = FramePlanner(scene).plan(request);
    return {plan.mesh->positionsOpen[0].x, plan.mesh->positionsClose[0].x};
}

void expectStill(const Ends& ends, double x) {
    EXPECT_EQ(ends.open, ends.close);  // to the last bit: nothing moves
    EXPECT_NEAR(ends.open, x, 1e-6);
}

GltfFile quadAlone() {
    GltfFile file;
    addQuad(file);
    file.addRoot({{"mesh", 0}});
    return file;
}

/// A quad that is at x = 0 and from `key` on, by a STEP key, at x = 8.
GltfFile jumpAt(float key) {
    GltfFile file = quadAlone();
    file.animate(0, "translation", {0.0f, key, key + 1.0f}, file.vec3s({0, 0, 0, 8, 0, 0, 8, 0, 0}), "STEP");
    return file;
}

TEST(ShutterJumps, AKeyAtAFramesTimeIsThatFramesAtAnyRate) {
    for (const double rate : {24.0, 25.0, 30.0, 60.0, 24000.0 / 1001.0, 30000.0 / 1001.0, 120.0})
        for (int k = 1; k <= 2 * static_cast<int>(rate); ++k) {
            SCOPED_TRACE(testing::Message() << "key at frame " << k << " at " << rate << " per second");
            // As exporters compute it: divided in double, divided in float, multiplied in float.
            const auto frame = static_cast<float>(k), single = static_cast<float>(rate);
            for (const float key : {static_cast<float>(k / rate), frame / single, frame * (1.0f / single)}) {
                const auto scene = loaded(jumpAt(key));
                expectStill(endsOf(*scene, requestOf(k, rate, 0.5)), 8.0);
                expectStill(endsOf(*scene, requestOf(k, rate, 0.0)), 8.0);
                expectStill(endsOf(*scene, requestOf(k - 1, rate, 1.0)), 0.0);
                expectStill(endsOf(*scene, requestOf(k - 0.001, rate, 0.0)), 0.0);
            }
        }
}

TEST(ShutterJumps, MoveToTheNearerEnd) {
    const auto scene = loaded(jumpAt(1.0f));
    for (const double u : {0.0, 0.01, 0.3, 0.49, 0.5}) expectStill(endsOf(*scene, requestOf(10.0 - u, 10, 1.0)), 8.0);
    for (const double u : {0.51, 0.7, 0.99, 1.0}) expectStill(endsOf(*scene, requestOf(10.0 - u, 10, 1.0)), 0.0);
}

TEST(ShutterJumps, SeveralInOneShutterLeaveWhatIsInItsMiddle) {
    GltfFile file = quadAlone();
    file.animate(0, "translation", {0, 1.1f, 1.2f, 1.8f, 1.9f, 3},
                 file.vec3s({0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0, 4, 0, 0}), "STEP");
    expectStill(endsOf(*loaded(file), requestOf(1, 1, 1.0)), 2.0);
}

TEST(ShutterJumps, WhatMovesBesideAJumpGoesOnMoving) {
    GltfFile file = quadAlone();
    file.add("nodes", {{"children", {0}}});
    file.json["scenes"][0]["nodes"] = {1};
    file.animate(0, "translation", {0, 2}, file.vec3s({0, 0, 0, 2, 0, 0}));
    file.animate(1, "translation", {0, 1.2f, 2}, file.vec3s({0, 0, 0, 10, 0, 0, 10, 0, 0}), "STEP");
    const Ends ends = endsOf(*loaded(file), requestOf(1, 1, 1.0));
    EXPECT_NEAR(ends.open, 11.0, 1e-6);
    EXPECT_NEAR(ends.close, 12.0, 1e-6);
}

TEST(ShutterJumps, OfRotationsAndScales) {
    GltfFile file = quadAlone();
    const int moved = file.vec3s({1, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0});
    file.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = moved;
    GltfFile scaled = file;
    file.animate(0, "rotation", {0, 1.3f, 2}, file.vec4s({0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0}), "STEP");
    expectStill(endsOf(*loaded(file), requestOf(1, 1, 1.0)), -1.0);
    scaled.animate(0, "scale", {0, 1.3f, 2}, scaled.vec3s({1, 1, 1, 3, 3, 3, 3, 3, 3}), "STEP");
    expectStill(endsOf(*loaded(scaled), requestOf(1, 1, 1.0)), 3.0);
}

TEST(ShutterJumps, OfBonesAndMorphWeights) {
    GltfFile bone;
    const int positions = bone.vec3s({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    const int joints = bone.addAccessor<std::uint8_t>(std::vector<std::uint8_t>(16, 0), "VEC4", 4);
    const int weights = bone.vec4s({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    bone.addMesh({{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}},
                 bone.addAccessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR", 1));
    bone.add("skins", {{"joints", {1}}});
    bone.addRoot({{"mesh", 0}, {"skin", 0}});
    bone.addRoot({{"name", "joint"}});
    bone.animate(1, "translation", {0, 1.6f, 2}, bone.vec3s({0, 0, 0, 5, 0, 0, 5, 0, 0}), "STEP");
    expectStill(endsOf(*loaded(bone), requestOf(1, 1, 1.0)), 0.0);
    expectStill(endsOf(*loaded(bone), requestOf(1.2, 1, 1.0)), 5.0);

    GltfFile morph = quadAlone();
    morph.json["meshes"][0]["primitives"][0]["targets"] =
        Json::array({{{"POSITION", morph.vec3s(std::vector<float>(12, 6.0f))}}});
    morph.animate(0, "weights", {0, 1.3f, 2}, morph.scalars({0, 1, 1}), "STEP");
    expectStill(endsOf(*loaded(morph), requestOf(1, 1, 1.0)), 6.0);
}

TEST(ShutterJumps, CamerasCutAndLightsSwitchPlace) {
    GltfFile file = quadAlone();
    file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}});
    file.json["extensionsUsed"] = {"KHR_lights_punctual"};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] =
        Json::array({{{"type", "spot"}, {"intensity", 100}, {"spot", Json::object()}}});
    file.addRoot({{"camera", 0}, {"translation", {0, 0, 5}}});
    file.addRoot({{"translation", {0, 0, 7}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    file.animate(1, "translation", {0, 1.3f, 2}, file.vec3s({0, 0, 5, 4, 0, 5, 4, 0, 5}), "STEP");
    file.animate(1, "rotation", {0, 1.3f, 2}, file.vec4s({0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 0, 0}), "STEP");
    file.animate(2, "translation", {0, 1.3f, 2}, file.vec3s({0, 0, 7, 3, 0, 7, 3, 0, 7}), "STEP");
    const auto scene = loaded(file);
    for (const auto& [frame, camera, light] : {std::array{1.0, 4.0, 3.0}, std::array{0.7, 0.0, 0.0}}) {
        const FramePlan plan = FramePlanner(*scene).plan(requestOf(frame, 1, 1.0));
        EXPECT_EQ(plan.camera.open.eye, plan.camera.close.eye);
        EXPECT_EQ(plan.camera.open.corner, plan.camera.close.corner);
        EXPECT_NEAR(plan.camera.open.eye.x + plan.origin.x, camera, 1e-6);
        EXPECT_FALSE(plan.motion.cameraMoves);
        EXPECT_EQ(plan.lightOpen.position, plan.lightClose.position);
        EXPECT_NEAR(plan.lightOpen.position.x, light, 1e-6);
    }
}

/// x = 1 to 11 from 0 s to 1 s; the end does not join the start.
GltfFile slide() {
    GltfFile file = quadAlone();
    file.animate(0, "translation", {0, 1}, file.vec3s({1, 0, 0, 11, 0, 0}));
    return file;
}

void expectEnds(const Ends& ends, double open, double close) {
    EXPECT_NEAR(ends.open, open, 1e-6);
    EXPECT_NEAR(ends.close, close, 1e-6);
}

TEST(ClipEnds, AreHeldWhereTheClipDoesNotLoop) {
    const auto scene = loaded(slide());
    for (const Looping looping : {Looping::Auto, Looping::Off}) {
        const auto ends = [&](double frame, double length, ShutterPosition position) {
            FrameRequest request = requestOf(frame, 10, length, position);
            request.looping = looping;
            return endsOf(*scene, request);
        };
        expectEnds(ends(0, 0.5, ShutterPosition::Centre), 1.0, 1.25);
        expectEnds(ends(0, 1.0, ShutterPosition::End), 1.0, 1.0);
        expectEnds(ends(1, 0.5, ShutterPosition::Centre), 1.75, 2.25);
        expectEnds(ends(9.5, 1.0, ShutterPosition::Start), 10.5, 11.0);
        expectEnds(ends(10, 0.5, ShutterPosition::Centre), 10.75, 11.0);
        expectEnds(ends(25, 0.5, ShutterPosition::Start), 11.0, 11.0);
        expectEnds(ends(-25, 0.5, ShutterPosition::Start), 1.0, 1.0);
    }
}

TEST(ClipEnds, AClipMadeToRepeatJumpsBetweenShuttersAlone) {
    const auto scene = loaded(slide());
    const auto ends = [&](double frame, double length) {
        FrameRequest request = requestOf(frame, 10, length);
        request.looping = Looping::On;
        return endsOf(*scene, request);
    };
    expectEnds(ends(10, 0.5), 1.0, 1.5);   // the second time round
    expectEnds(ends(25, 0.5), 6.0, 6.5);   // the third
    expectEnds(ends(-5, 0.5), 6.0, 6.5);   // the one before the first
    expectEnds(ends(9.7, 1.0), 1.0, 1.7);  // the jump at u = 0.3 goes to the opening
    expectEnds(ends(9.3, 1.0), 10.3, 11.0);
    expectEnds(ends(9.5, 0.0), 10.5, 10.5);
}

TEST(ClipEnds, ALoopIsBlurredAcrossItsEndUnlessItIsSwitchedOff) {
    GltfFile file = quadAlone();
    file.animate(0, "translation", {0, 1, 2}, file.vec3s({0, 0, 0, 10, 0, 0, 0, 0, 0}));
    const auto scene = loaded(file);
    FrameRequest request = requestOf(1.9, 1, 0.3);
    expectEnds(endsOf(*scene, request), 1.0, 2.0);
    request.looping = Looping::On;
    expectEnds(endsOf(*scene, request), 1.0, 2.0);
    request.looping = Looping::Off;
    expectEnds(endsOf(*scene, request), 1.0, 0.0);
    request.frame = 2.5;
    expectEnds(endsOf(*scene, request), 0.0, 0.0);
}

TEST(ClipEnds, StepKeysAcrossTheLoopPointAreReadInTheMiddle) {
    GltfFile file = quadAlone();
    file.animate(0, "translation", {0, 1, 2}, file.vec3s({3, 0, 0, 9, 0, 0, 3, 0, 0}), "STEP");
    const auto scene = loaded(file);
    expectStill(endsOf(*scene, requestOf(1.9, 1, 0.3)), 3.0);
    expectStill(endsOf(*scene, requestOf(1.6, 1, 0.5)), 9.0);
}

}  // namespace
}  // namespace timeshade
