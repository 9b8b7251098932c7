// What the window decides without a window: time, camera, how coarsely to draw, and where things go.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <future>

#include <gtest/gtest.h>
#include <timeshade/paths.h>

#include "core/error.h"
#include "image/image_file.h"
#include "panels/widgets.h"
#include "scene_catalogue.h"
#include "techniques/registry.h"
#include "window/frame_times.h"
#include "window/layout.h"
#include "window/mouse_queue.h"
#include "window/orbit_camera.h"
#include "window/playback.h"
#include "window/preview_quality.h"
#include "window/probe_bars.h"
#include "window/scene_loading.h"
#include "window/window_memory.h"

namespace timeshade {
namespace {

TEST(SceneLoading, WhatIsGivenUpIsNotWaitedFor) {
    std::promise<void> gate;
    SceneLoading loading;
    loading.begin("folder/slow.glb", [open = gate.get_future().share()](const LoadingWatch& watch) {
        watch({"meshes", 1, 3});
        open.wait();
        watch({"images"});
        ADD_FAILURE() << "the next step of what was given up";
        return std::unique_ptr<Scene>();
    });
    ASSERT_TRUE(loading.on());
    EXPECT_EQ(loading.take(), nullptr);
    EXPECT_EQ(loading.text().substr(0, 31), "loading slow.glb: meshes 2 of 3");
    loading.cancel();
    EXPECT_FALSE(loading.on());
    loading.begin("pillars", [](const LoadingWatch& watch) { return openScene("pillars", SceneChoice{}, {}, watch); });
    std::unique_ptr<Scene> scene;
    while (!scene) scene = loading.take();
    EXPECT_EQ(scene->name(), "pillars");
    EXPECT_FALSE(loading.on());
    loading.begin("none", [](const LoadingWatch&) -> std::unique_ptr<Scene> { throw Error("no such scene"); });
    EXPECT_THROW(loading.take(), Error);
    gate.set_value();
}

TEST(Playback, StaysWithinTheLoop) {
    Playback playback;
    playback.setLoop(2.0, 24.0);
    EXPECT_EQ(playback.loopFrames(), 48);
    playback.step(-1);
    EXPECT_EQ(playback.frame(), 47.0);
    playback.step(1);
    EXPECT_EQ(playback.frame(), 0.0);
    playback.play(true);
    playback.advance(1.0 / 48.0);
    EXPECT_EQ(playback.frame(), 0.0) << "half a frame is kept for later";
    playback.advance(1.0 / 48.0 + 1e-9);
    EXPECT_EQ(playback.frame(), 1.0);
    playback.advance(2.0);
    EXPECT_EQ(playback.frame(), 1.0) << "a whole loop";
}

TEST(Playback, TakesAnyFrameFromTheCommandLine) {
    Playback playback;
    playback.setLoop(1.0, 10.0);
    playback.jump(-3.5);
    EXPECT_EQ(playback.frame(), -3.5);
    EXPECT_EQ(playback.frameInLoop(), 6);
    playback.jump(1e6);
    EXPECT_EQ(playback.frameInLoop(), 0);
    playback.step(1);
    EXPECT_EQ(playback.frame(), 1.0);
}

TEST(Playback, DoesNotPlayWhatDoesNotMove) {
    Playback playback;
    playback.setLoop(0.0, 24.0);
    playback.play(true);
    EXPECT_FALSE(playback.playing());
    playback.step(1);
    EXPECT_EQ(playback.frame(), 0.0);
}

/// All that happens while one slow frame is drawn.
TEST(MouseQueue, ADragDuringOneFrameBeginsWhereTheButtonWentDown) {
    MouseQueue mouse;
    mouse.moved(10.0, 5.0);
    mouse.pressed(0, true);
    mouse.moved(20.0, 6.0);
    mouse.moved(30.0, 7.0);
    mouse.pressed(0, false);
    MouseState state = mouse.next();
    EXPECT_EQ(state.x, 10.0);
    EXPECT_TRUE(state.down[0]);
    EXPECT_TRUE(mouse.pending());
    state = mouse.next();
    EXPECT_EQ(state.x, 30.0);
    EXPECT_TRUE(state.down[0]) << "moved before it was let go";
    state = mouse.next();
    EXPECT_EQ(state.x, 30.0);
    EXPECT_EQ(state.y, 7.0);
    EXPECT_FALSE(state.down[0]);
    EXPECT_FALSE(mouse.pending());
}

TEST(MouseQueue, NoClickIsLost) {
    MouseQueue mouse;
    for (int i = 0; i < 3; ++i) {
        mouse.pressed(0, true);
        mouse.pressed(0, false);
    }
    mouse.pressed(7, true);
    for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(mouse.next().down[0]);
        EXPECT_FALSE(mouse.next().down[0]);
    }
    EXPECT_FALSE(mouse.pending());
}

Bounds unitBounds() {
    Bounds bounds;
    bounds.add(glm::dvec3(-1.0));
    bounds.add(glm::dvec3(1.0));
    return bounds;
}

TEST(OrbitCamera, KeepsItsDistanceAndLooksAtTheSamePoint) {
    OrbitCamera camera(lookAt({0.0, 2.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.8, 0.01), unitBounds());
    const double distance = glm::length(camera.pose().eye);
    for (int i = 0; i < 1000; ++i) camera.orbit(0.1, i % 2 == 0 ? 0.7 : -0.65);
    EXPECT_NEAR(glm::length(camera.pose().eye), distance, 1e-9);
    EXPECT_NEAR(glm::length(glm::cross(glm::normalize(camera.pose().eye), camera.pose().axes[2])), 0.0, 1e-9);
    EXPECT_LT(std::abs(camera.pose().axes[2].y), 1.0) << "never straight down";
    EXPECT_NEAR(glm::determinant(camera.pose().axes), 1.0, 1e-9);
    EXPECT_NEAR(camera.pose().axes[0].y, 0.0, 1e-9) << "the horizon stays level";
}

TEST(OrbitCamera, ZoomHasEnds) {
    OrbitCamera camera(lookAt({0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.8, 0.01), unitBounds());
    for (int i = 0; i < 1000; ++i) camera.zoom(0.5);
    EXPECT_GT(camera.pose().eye.z, 0.0);
    EXPECT_LT(camera.pose().nearDistance, camera.pose().eye.z);
    for (int i = 0; i < 1000; ++i) camera.zoom(2.0);
    EXPECT_TRUE(std::isfinite(camera.pose().eye.z));
}

TEST(OrbitCamera, PanMovesByTheWidthThatIsSeen) {
    OrbitCamera camera(lookAt({0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 2.0 * std::atan(0.5), 0.01),
                       unitBounds());
    camera.pan(0.0, 1.0);  // the picture is 5 units high where the point of interest lies
    EXPECT_NEAR(camera.pose().eye.y, 5.0, 1e-9);
    EXPECT_NEAR(camera.pose().eye.z, 5.0, 1e-9);
}

FrameRequest fullRequest() {
    FrameRequest request;
    request.width = 1280;
    request.height = 720;
    return request;
}

/// A renderer whose time is in proportion to samples and to map texels.
double costOf(const FrameRequest& r) {
    return r.samplesPerPixel *
           (static_cast<double>(r.width) * r.height * 2.5e-4 + static_cast<double>(r.mapSize.texels()) * 1e-4);
}

TEST(PreviewQuality, BecomesFastEnoughAndStaysSo) {
    PreviewQuality quality(false);
    EXPECT_EQ(quality.level(), 0) << "hardware is trusted first";
    double cost = 0.0;
    for (int i = 0; i < 20; ++i) {
        cost = costOf(quality.reduced(fullRequest(), quality.level()));
        quality.measured(quality.level(), cost);
    }
    EXPECT_LE(cost, PreviewQuality::slowMilliseconds);
    EXPECT_GT(quality.level(), 0);
}

TEST(PreviewQuality, DrawsAllOfAFastPicture) {
    PreviewQuality quality(true);
    for (int i = 0; i < 20; ++i) quality.measured(quality.level(), 5.0);
    EXPECT_EQ(quality.level(), 0);
    const FrameRequest full = fullRequest(), drawn = quality.reduced(full, 0);
    EXPECT_EQ(drawn.width, full.width);
    EXPECT_EQ(drawn.samplesPerPixel, full.samplesPerPixel);
    EXPECT_EQ(drawn.mapSize, full.mapSize);
}

TEST(PreviewQuality, ForgivesOneSlowPicture) {
    PreviewQuality quality(false);
    quality.measured(0, 900.0);  // it compiled shaders
    EXPECT_GT(quality.level(), 0);
    for (int i = 0; i < 200 && quality.level() > 0; ++i) quality.measured(quality.level(), 5.0);
    EXPECT_EQ(quality.level(), 0);
}

TEST(PreviewQuality, NeverAsksForNothing) {
    const PreviewQuality quality(true);
    FrameRequest tiny;
    tiny.width = tiny.height = tiny.samplesPerPixel = 1;
    tiny.mapSize = minimumMapSide;
    for (int level = 0; level < PreviewQuality::levels; ++level) {
        const FrameRequest drawn = quality.reduced(tiny, level);
        EXPECT_EQ(std::min({drawn.width, drawn.height, drawn.samplesPerPixel}), 1);
        EXPECT_EQ(drawn.mapSize, minimumMapSide);
    }
}

bool overlap(const Area& a, const Area& b) {
    return !a.empty() && !b.empty() && a.position.x < b.position.x + b.size.x &&
           b.position.x < a.position.x + a.size.x && a.position.y < b.position.y + b.size.y &&
           b.position.y < a.position.y + a.size.y;
}

TEST(Layout, NothingOverlapsOrSticksOut) {
    for (const float scale : {0.5f, 1.0f, 2.0f, 4.0f}) {
        for (const float width : {1.0f, 40.0f, 300.0f, 900.0f, 3840.0f}) {
            for (const float height : {1.0f, 30.0f, 200.0f, 600.0f, 2160.0f}) {
                const Layout layout = layoutOf({width, height}, scale, true);
                EXPECT_FALSE(overlap(layout.side, layout.transport));
                EXPECT_FALSE(layout.picture.empty());
                for (const Area& area : {layout.side, layout.transport, layout.picture}) {
                    EXPECT_LE(area.position.x + area.size.x, width);
                    EXPECT_LE(area.position.y + area.size.y, height);
                }
                const Layout bare = layoutOf({width, height}, scale, false);
                EXPECT_EQ(bare.picture.size.x, width);
                EXPECT_TRUE(bare.side.empty() && bare.transport.empty());
            }
        }
    }
    const Layout usual = layoutOf({1280.0f, 720.0f}, 1.0f, true);
    EXPECT_FALSE(overlap(usual.side, usual.picture));
    EXPECT_FALSE(overlap(usual.transport, usual.picture));
}

TEST(Layout, ASmallWindowShowsItsPicture) {
    const Layout small = layoutOf({500.0f, 400.0f}, 1.0f, true);
    EXPECT_FALSE(overlap(small.side, small.picture));
    EXPECT_GE(small.picture.size.x, 200.0f);
    EXPECT_GE(small.side.size.x, 200.0f);
    const Layout wide = layoutOf({1500.0f, 900.0f}, 1.0f, true, 500.0f);
    EXPECT_EQ(wide.side.size.x, 500.0f);
    EXPECT_EQ(layoutOf({1500.0f, 900.0f}, 1.0f, true, 5000.0f).picture.size.x, 280.0f) << "some is left";
}

TEST(FrameTimes, MedianOfTheLastFrames) {
    FrameTimes times;
    EXPECT_EQ(times.frames(), 0u);
    EXPECT_TRUE(times.medians().empty());
    times.add({});
    EXPECT_EQ(times.frames(), 0u) << "a frame without figures is no figure of 0";
    times.add({{"build", 100.0}, {"lookup", 1.0}});
    times.add({{"build", 2.0}, {"lookup", 4.0}});
    times.add({{"build", 3.0}, {"lookup", 2.0}});
    ASSERT_EQ(times.medians().size(), 2u);
    EXPECT_EQ(times.medians()[0].milliseconds, 3.0);
    EXPECT_EQ(times.medians()[1].milliseconds, 2.0);
    EXPECT_EQ(times.medianTotal(), 6.0) << "of 101, 6 and 5";
    for (int i = 0; i < 100; ++i) times.add({{"build", 7.0}});
    EXPECT_EQ(times.frames(), FrameTimes::kept);
    EXPECT_EQ(times.medianTotal(), 7.0);
}

TEST(Titles, OfSettings) {
    EXPECT_EQ(titleOfKey("dynamic_bias"), "Dynamic bias");
    EXPECT_EQ(titleOfKey("pcf_radius"), "PCF radius");
    EXPECT_EQ(titleOfKey(""), "");
}

TEST(WindowMemory, ComesBackAsItWas) {
    const WindowMemory memory{
        1100, 640, 1.25, {{"section.plan", true}, {"section.camera", false}}, {"/a/\xff.glb", "/a/b.glb"}};
    WindowMemory read = memoryOfJson(jsonOf(memory), "F.json");
    EXPECT_EQ(read.recentScenes.size(), 2u) << "a name that is not UTF-8 is no reason to fail";
    read.recentScenes[0] = memory.recentScenes[0];
    EXPECT_EQ(read, memory);
    EXPECT_EQ(memoryOfJson(jsonOf({1, 1, 1.0, {}, {}}), "F.json"), WindowMemory{})
        << "nobody wants such a window again";
    EXPECT_EQ(memoryOfJson(R"({"of a later version": [1]})", "F.json"), WindowMemory{});
}

TEST(WindowMemory, WhatMakesNoSenseIsNamed) {
    for (const char* text :
         {"", "[]", "{", R"({"size": 5})", R"({"size": [1, 2]})", R"({"size": [1000, "wide"]})",
          R"({"size": [9e99, 700]})", R"({"text_size": 90})", R"({"sections": {"section.plan": "open"}})",
          R"({"sections": []})", R"({"recent": [1]})"}) {
        try {
            memoryOfJson(text, "F.json");
            FAIL() << text;
        } catch (const Error& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with("F.json: ")) << error.what();
        }
    }
}

/// Each technique has a page; its picture, if there is one, is drawn by scripts/technique_pages.sh.
TEST(TechniquePages, AreThere) {
    std::uintmax_t bytes = 0;
    for (const TechniqueDescription& technique : techniqueDescriptions()) {
        EXPECT_FALSE(technique.wrong.empty() || technique.look.empty()) << technique.name << " has no page";
        const std::filesystem::path file =
            std::filesystem::path(TIMESHADE_SOURCE_DIRECTORY) / "renderer/techniques" / technique.name / "page.png";
        EXPECT_EQ(std::filesystem::exists(file), !technique.picture.empty()) << file;
        if (technique.picture.empty()) continue;
        const DisplayImage picture = readPng(file);
        EXPECT_EQ(picture.width, 448) << technique.name;
        EXPECT_EQ(picture.height, 176) << technique.name;
        bytes += std::filesystem::file_size(file);
    }
    EXPECT_LT(bytes, 400'000u) << "they are small";
}

std::vector<float> sidesOf(const ProbeBar& bar) { return {bar.left, bar.right, bar.top, bar.bottom, bar.grey}; }

TEST(ProbeBars, AreAsWideAsTheIntervalsOfTheirValues) {
    // Instants, one of them at the closing of the shutter and one without a value; then strata; then the shutter.
    const std::vector<ProbeBar> instants = barsOf(
        {{0.25f, 0.25f, 1.0f, 0.0f}, {0.5f, 0.5f, -1.0f, -1.0f}, {1.0f, 1.0f, 0.0f, 1.0f}}, &ProbeValue::lit, 0.125f);
    ASSERT_EQ(instants.size(), 2u);
    EXPECT_EQ(sidesOf(instants[0]), (std::vector<float>{0.1875f, 0.3125f, 0.0f, 1.0f, 1.0f}));
    EXPECT_EQ(sidesOf(instants[1]), (std::vector<float>{0.875f, 1.0f, 0.0f, 1.0f, 0.0f})) << "stays in the strip";
    const std::vector<ProbeBar> strata =
        barsOf({{0.0f, 0.5f, 0.25f, 0.5f}, {0.5f, 1.0f, 0.75f, 1.0f}}, &ProbeValue::truth, 0.125f);
    ASSERT_EQ(strata.size(), 2u);
    EXPECT_EQ(sidesOf(strata[0]), (std::vector<float>{0.0f, 0.5f, 0.0f, 1.0f, 0.5f}));
    EXPECT_EQ(sidesOf(strata[1]), (std::vector<float>{0.5f, 1.0f, 0.0f, 1.0f, 1.0f}));
    const std::vector<ProbeBar> shutter = barsOf({{0.0f, 1.0f, 0.25f, 0.5f}}, &ProbeValue::lit, 0.125f);
    ASSERT_EQ(shutter.size(), 1u);
    EXPECT_EQ(sidesOf(shutter[0]), (std::vector<float>{0.0f, 1.0f, 0.0f, 1.0f, 0.25f}));
}

TEST(ProbeBars, ShareTheHeightWhereTheirIntervalIsTheSame) {
    const std::vector<ProbeValue> values{
        {0.0f, 1.0f, 0.25f, 0.5f}, {0.0f, 1.0f, -1.0f, -1.0f}, {0.0f, 1.0f, 0.75f, 0.125f}};
    const std::vector<ProbeBar> lit = barsOf(values, &ProbeValue::lit, 0.125f);
    ASSERT_EQ(lit.size(), 2u);
    EXPECT_EQ(sidesOf(lit[0]), (std::vector<float>{0.0f, 1.0f, 0.0f, 0.5f, 0.75f}));
    EXPECT_EQ(sidesOf(lit[1]), (std::vector<float>{0.0f, 1.0f, 0.5f, 1.0f, 0.25f}));
    const std::vector<ProbeBar> truth = barsOf(values, &ProbeValue::truth, 0.125f);
    ASSERT_EQ(truth.size(), 2u);
    EXPECT_EQ(truth[0].grey, 0.125f) << "in the order of the values above";
    EXPECT_EQ(truth[1].grey, 0.5f);
}

TEST(ProbeBars, LeaveATruthThatIsNotThereEmpty) {
    const std::vector<ProbeValue> values{{0.0f, 1.0f, 0.75f, -1.0f}, {0.0f, 1.0f, 0.25f, 1.0f}};
    const std::vector<ProbeBar> truth = barsOf(values, &ProbeValue::truth, 0.125f);
    ASSERT_EQ(truth.size(), 1u);
    EXPECT_EQ(sidesOf(truth[0]), (std::vector<float>{0.0f, 1.0f, 0.5f, 1.0f, 1.0f}));
    EXPECT_TRUE(barsOf({}, &ProbeValue::lit, 0.125f).empty());
}

}  // namespace
}  // namespace timeshade
