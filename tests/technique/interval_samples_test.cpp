// Interval samples: what a position sees is a partition of the shutter, the right triangle in each of its parts, and
// the same whatever the plan, the room for segments and the driver's loops allow at once. Pictures have no noise in
// time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/error.h"
#include "measure/segment_comparison.h"
#include "oracle/oracle.h"
#include "scene_catalogue.h"
#include "shared/sample_pattern.shared.h"
#include "support/crowded_scene.h"
#include "support/drawn_here.h"
#include "support/gl_environment.h"
#include "support/moving_scene.h"
#include "support/shader_copy.h"
#include "support/thorough.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

using PartValue = FrameRenderer::PartValue;

const std::uint32_t width = usualOrAll(40u, 64u), height = usualOrAll(30u, 48u);

FrameRequest intervalRequest(int positions = 2) {
    FrameRequest request;
    request.width = static_cast<int>(width);
    request.height = static_cast<int>(height);
    request.samples = CameraSamples::Intervals;
    request.samplesPerPixel = positions;
    request.mapSize = 64;
    return request;
}

FrameRequest requestOf(const Scene& scene, FrameRequest request) {
    request.frame = scene.defaults().frame;
    request.shutter.framesPerSecond = scene.defaults().framesPerSecond;
    request.shutter.length = scene.defaults().shutterLength;
    return request;
}

std::vector<PartValue> drawParts(FrameRenderer& renderer, const Scene& scene, const FrameRequest& request,
                                 const std::string& techniqueName) {
    const std::unique_ptr<Technique> technique = makeTechnique(techniqueName, renderer.programs());
    renderer.draw(FramePlanner(scene).plan(request), *technique, View::Visibility);
    return renderer.readParts();
}

/// Parts of one triangle that follow each other become one.
std::vector<SeenPart> segmentsOf(const std::vector<PartValue>& parts) {
    std::vector<SeenPart> segments;
    for (const PartValue& value : parts) {
        const SeenPart& part = value.part;
        if (!segments.empty() && segments.back().place == part.place && segments.back().triangle == part.triangle)
            segments.back().end = part.end;
        else
            segments.push_back(part);
    }
    return segments;
}

/// Scenes by name, random quads that pass through each other ("quads"), solids in each other ("crowd").
std::unique_ptr<Scene> sceneOf(const std::string& name) {
    if (name == "quads") return makeMovingScene({.seed = 3});
    if (name == "crowd") return makeCrowdedScene({.seed = 5});
    if (name == "turning") return makeMovingScene({.seed = 4, .cameraTurns = true});
    if (name == "around") return makeMovingScene({.seed = 3, .aroundTheEye = true});
    return openScene(name, "");
}

class IntervalSamplesOf : public DrawnHere<std::string> {
  protected:
    std::unique_ptr<Scene> scene_ = sceneOf(GetParam());
    FrameRequest request_ = requestOf(*scene_, intervalRequest());
};

TEST_P(IntervalSamplesOf, ArePartitionsOfTheShutter) {
    for (const char* technique : {"integral", "exact"}) {
        const std::vector<PartValue> parts = drawParts(sharedRenderer(), *scene_, request_, technique);
        std::uint32_t place = 0;
        float end = 1.0f;
        for (const PartValue& value : parts) {
            if (end == 1.0f) {
                ASSERT_EQ(value.part.begin, 0.0f);
                ASSERT_EQ(value.part.place, place++);
            } else {
                ASSERT_EQ(value.part.begin, end);
                ASSERT_EQ(value.part.place, place - 1);
            }
            ASSERT_GT(value.part.end, value.part.begin);
            end = value.part.end;
        }
        EXPECT_EQ(end, 1.0f);
        EXPECT_EQ(place, width * height * 2u);
    }
}

/// The places of all positions, in the order of their numbers.
std::vector<glm::vec2> placesOf(const FramePlan& plan) {
    std::vector<glm::vec2> places;
    for (std::uint32_t y = 0; y < plan.block.imageSize.y; ++y)
        for (std::uint32_t x = 0; x < plan.block.imageSize.x; ++x)
            for (std::uint32_t k = 0; k < plan.block.positions; ++k)
                places.push_back(glm::vec2(x, y) +
                                 glm::vec2(shared::cameraSample({x, y}, k, plan.block.seed, plan.block.pixelCentres)));
    return places;
}

/// Ends within 1e-5 of those of exact arithmetic, or within 1/2000 pixel of the edge.
void expectThoseOfTheOracle(const Scene& scene, const FrameRequest& request) {
    const FramePlan plan = FramePlanner(scene).plan(request);
    const std::vector<glm::vec2> places = placesOf(plan);
    std::vector<std::vector<SeenSegment>> got(places.size());
    for (const SeenPart& s : segmentsOf(drawParts(sharedRenderer(), scene, request, "integral")))
        got[s.place].push_back({s.triangle, static_cast<double>(s.begin), static_cast<double>(s.end)});
    const SegmentComparison comparison = compareSegments(SegmentOracle(plan), plan, places, got);
    EXPECT_EQ(comparison.count(SegmentDisagreement::Cause::Malformed), 0u);
    const std::size_t wrong = comparison.count(SegmentDisagreement::Cause::Different);
    EXPECT_LE(wrong, 0u) << comparison.partsPerMillion() << " ppm";
    testing::Test::RecordProperty("beside", static_cast<int>(comparison.beside));
}

TEST_P(IntervalSamplesOf, AreThoseOfTheOracle) { expectThoseOfTheOracle(*scene_, request_); }

/// The share of light that each part has, on the position's ray.
TEST_P(IntervalSamplesOf, AreLitAsTheOracleSays) {
    const FramePlan plan = FramePlanner(*scene_).plan(request_);
    const std::vector<glm::vec2> places = placesOf(plan);
    const SegmentOracle oracle(plan);
    double sum = 0.0, count = 0.0, far = 0.0;
    for (const PartValue& value : drawParts(sharedRenderer(), *scene_, request_, "integral")) {
        if (value.part.place % 7 != 0 || value.part.triangle == NO_TRIANGLE) continue;
        const SeenSegment seen{value.part.triangle, static_cast<double>(value.part.begin),
                               static_cast<double>(value.part.end)};
        const LitSegment truth = oracle.litOver(plan, places[value.part.place], std::span(&seen, 1)).front();
        const double difference =
            std::abs(static_cast<double>(value.lit * value.tested) * (seen.u1 - seen.u0) - truth.lit);
        sum += difference;
        count += 1.0;
        if (difference > 1e-4) far += 1.0;
    }
    // Receivers that rotate or deform are followed by chords, and their places are floats. A camera that turns sweeps
    // its rays over long ways, of which chords are a share.
    EXPECT_LE(sum / count, plan.camera.turns ? 2e-5 : 4e-6);
    EXPECT_LE(far / count, 0.01) << far << " of " << count;
}

/// A camera sample of the same pixel and number has the same position, and one time.
TEST_P(IntervalSamplesOf, SeeWhatTheOracleSeesAtAnyTime) {
    FrameRequest strata = request_;
    strata.samples = CameraSamples::Strata;
    const std::vector<SeenPart> segments = segmentsOf(drawParts(sharedRenderer(), *scene_, request_, "static"));
    FramePlanner planner(*scene_);
    const FramePlan plan = planner.plan(strata);
    const Oracle oracle(plan);
    const std::vector<std::uint32_t> seen = oracle.tracePrimaries(plan);
    const std::size_t pixels = seen.size() / 2;
    std::size_t wrong = 0, marginal = 0, at = 0;
    for (std::uint32_t pixel = 0; pixel < pixels; ++pixel)
        for (std::uint32_t k = 0; k < 2; ++k) {
            const SampleIndex sample{pixel % width, pixel / width, k};
            const float xi = shared::cameraSample({sample.x, sample.y}, k, plan.block.seed, 0).z;
            const float u = shared::sampleTime(plan.block.timeBase, plan.block.timeScale, k, xi);
            while (segments[at].place < pixel * 2 + k || segments[at].end < u) ++at;
            if (segments[at].triangle == seen[k * pixels + pixel]) continue;
            const Oracle::ResolvedPrimary resolved = oracle.resolvePrimary(plan, sample);
            if (resolved.triangle != segments[at].triangle) ++(resolved.marginal ? marginal : wrong);
        }
    EXPECT_EQ(wrong, 0u);
    EXPECT_LE(marginal, 2u);
}

/// For how long of the shutter two lists of one position see different triangles.
double differenceOf(const std::vector<SeenPart>& a, std::size_t i, const std::vector<SeenPart>& b, std::size_t j) {
    const std::uint32_t place = a[i].place;
    double different = 0.0;
    float at = 0.0f;
    while (i < a.size() && j < b.size() && a[i].place == place && b[j].place == place) {
        const float next = std::min(a[i].end, b[j].end);
        if (a[i].triangle != b[j].triangle) different += static_cast<double>(next - at);
        at = next;
        if (a[i].end == next) ++i;
        if (b[j].end == next) ++j;
    }
    return different;
}

/// By two ways: other triangles for longer than 1e-5 of the shutter at most in so many positions.
void expectSameSegments(const std::vector<SeenPart>& a, const std::vector<SeenPart>& b, std::size_t mostDifferent) {
    std::size_t different = 0, j = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (i > 0 && a[i].place == a[i - 1].place) continue;
        while (b[j].place < a[i].place) ++j;
        ASSERT_EQ(b[j].place, a[i].place);
        different += differenceOf(a, i, b, j) > 1e-5 ? 1u : 0u;
    }
    EXPECT_LE(different, mostDifferent);
}

/// Always in the larger picture: where two triangles cross at a shallow angle, rounding shows in some of 6,144 places.
TEST_P(IntervalSamplesOf, AreTheSameWithEverythingDynamic) {
    request_.width = 64;
    request_.height = 48;
    const std::vector<SeenPart> planned = segmentsOf(drawParts(sharedRenderer(), *scene_, request_, "integral"));
    request_.forceDynamic = true;
    expectSameSegments(planned, segmentsOf(drawParts(sharedRenderer(), *scene_, request_, "integral")), 2);
}

/// With little room for segments, crowded positions are solved in halves of the shutter.
TEST_P(IntervalSamplesOf, NeverDropASegment) {
    const std::vector<SeenPart> once = segmentsOf(drawParts(sharedRenderer(), *scene_, request_, "integral"));
    const ShaderCopy shaders;
    shaders.apply({"lib/seen_partition.glsl", "SEGMENTS_TOGETHER 24", "SEGMENTS_TOGETHER 12"});
    FrameRenderer renderer;
    expectSameSegments(once, segmentsOf(drawParts(renderer, *scene_, request_, "integral")), 0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, IntervalSamplesOf,
                         testing::Values("crossing", "cubes", "rising", "octopus", "chess", "quads", "crowd", "around",
                                         "turning"),
                         [](const testing::TestParamInfo<std::string>& tested) { return tested.param; });

TEST(IntervalSamples, OfManyTrianglesAreThoseOfTheOracle) {
    for (const SettingTexts& settings : {SettingTexts{}, SettingTexts{{"cubes.count", "2500"}}}) {
        const std::unique_ptr<Scene> scene = openScene(settings.empty() ? "pillars" : "cubes", "", settings);
        expectThoseOfTheOracle(*scene, requestOf(*scene, intervalRequest(1)));
    }
}

/// Files by others, which are not part of the project, in the middle of what moves in them.
TEST(IntervalSamples, OfForeignFilesAreThoseOfTheOracle) {
    const char* folder = std::getenv("TIMESHADE_SHARED_GLTF");
    if (folder == nullptr) GTEST_SKIP() << "TIMESHADE_SHARED_GLTF names no folder";
    const std::pair<const char*, double> files[] = {{"Fox.glb", 7.0},
                                                    {"BoxAnimated.glb", 40.0},
                                                    {"AnimatedMorphCube.glb", 20.0},
                                                    {"03_skinned_cylinder/03_skinned_cylinder.gltf", 20.0}};
    for (const auto& [file, at] : files) {
        SCOPED_TRACE(file);
        const std::unique_ptr<Scene> scene = openScene(std::filesystem::path(folder) / file, "");
        FrameRequest request = requestOf(*scene, intervalRequest());
        request.frame = at;
        request.shutter.length = 2.0;
        expectThoseOfTheOracle(*scene, request);
    }
}

/// A solved shadow on solved samples has no random time in it: with positions at pixel centres no seed makes a
/// difference.
TEST(IntervalSamples, HaveNoNoiseInTime) {
    const std::unique_ptr<Scene> scene = openScene("cubes", "");
    FrameRequest request = requestOf(*scene, intervalRequest(1));
    request.pixelCentres = true;
    FramePlanner planner(*scene);
    std::vector<float> first;
    for (std::uint32_t seed = 1; seed <= 16; ++seed) {
        request.seed = seed;
        const std::unique_ptr<Technique> technique = makeTechnique("integral", sharedRenderer().programs());
        sharedRenderer().draw(planner.plan(request), *technique, View::Final);
        const std::vector<float> picture = sharedRenderer().readRadiance().rgb;
        if (first.empty()) first = picture;
        ASSERT_EQ(picture, first) << "seed " << seed;
    }
}

/// Where a light moves, what is lit early is shaded as it is early: the mean of shading times visibility, against
/// `exact` at many instants of the same positions.
TEST(IntervalSamples, AreShadedAsTheyAreLit) {
    const std::unique_ptr<Scene> scene = openScene("pillars", "");
    FrameRequest request = requestOf(*scene, intervalRequest(1));
    request.pixelCentres = true;
    FramePlanner planner(*scene);
    const auto radianceOf = [&](const char* name) {
        const std::unique_ptr<Technique> technique = makeTechnique(name, sharedRenderer().programs());
        sharedRenderer().draw(planner.plan(request), *technique, View::Final);
        return sharedRenderer().readRadiance().rgb;
    };
    const std::vector<float> solved = radianceOf("integral");
    constexpr std::uint32_t seeds = 8;
    std::vector<double> sampled(solved.size());
    request.timeStrata = 32;
    for (request.seed = 1; request.seed <= seeds; ++request.seed) {
        const std::vector<float> picture = radianceOf("exact");
        for (std::size_t i = 0; i < sampled.size(); ++i) sampled[i] += static_cast<double>(picture[i]) / seeds;
    }
    double squares = 0.0;
    for (std::size_t i = 0; i < solved.size(); ++i)
        squares += std::pow(static_cast<double>(solved[i]) - sampled[i], 2.0);
    // Most of it is the noise of the instants; shading in the middle of each segment has 0.00102.
    EXPECT_LE(std::sqrt(squares / static_cast<double>(solved.size())), 6e-4);
}

/// Nothing moves: one sample a position, drawn as ever.
TEST(IntervalSamples, OfAStaticSceneAreItsSamples) {
    const std::unique_ptr<Scene> scene = openScene("cubes", "");
    FrameRequest request = requestOf(*scene, intervalRequest());
    request.shutter.length = 0.0;
    FramePlanner planner(*scene);
    const std::unique_ptr<Technique> technique = makeTechnique("exact", sharedRenderer().programs());
    sharedRenderer().draw(planner.plan(request), *technique, View::Visibility);
    EXPECT_FALSE(sharedRenderer().hasIntervalSamples());
    const std::vector<float> lit = sharedRenderer().readVisibility();
    request.samples = CameraSamples::Strata;
    sharedRenderer().draw(planner.plan(request), *technique, View::Visibility);
    EXPECT_EQ(sharedRenderer().readVisibility(), lit);
}

/// What is drawn sample by sample is refused by name, not drawn as something else.
TEST(IntervalSamples, AreRefusedByWhatNeedsATimeASample) {
    const std::unique_ptr<Scene> scene = openScene("crossing", "");
    FramePlanner planner(*scene);
    const FramePlan plan = planner.plan(requestOf(*scene, intervalRequest()));
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        const std::unique_ptr<Technique> technique = makeTechnique(description.name, sharedRenderer().programs());
        if (technique->hasOwnLookup() || technique->renders() > 1)
            EXPECT_THROW(sharedRenderer().draw(plan, *technique, View::Final), Error) << description.name;
        else
            EXPECT_NO_THROW(sharedRenderer().draw(plan, *technique, View::Final)) << description.name;
    }
}

}  // namespace
}  // namespace timeshade
