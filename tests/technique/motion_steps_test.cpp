// A shutter that is cut into linear pieces: nearer to the true motion, and the same picture where motion is linear.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "measure/reference.h"
#include "measure/reference_technique.h"
#include "measure/reference_visibility.h"
#include "measure/verification.h"
#include "support/gl_environment.h"
#include "support/moving_scene.h"
#include "support/spinning_cube.h"
#include "support/thorough.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

FrameRequest requestOf(int samples, int steps, std::uint32_t seed = 1) {
    FrameRequest request = ProceduralScene::request(64, 48, samples, 256, seed);
    request.motionSteps = steps;
    return request;
}

struct Samples {
    std::vector<std::uint32_t> triangles;
    std::vector<float> lit;
};

/// Of all renders, one after the other.
Samples drawn(const FramePlan& plan, Technique& technique) {
    FrameRenderer& renderer = sharedRenderer();
    Samples samples;
    renderer.begin(plan, technique, View::Visibility);
    for (bool complete = false; !complete;) {
        complete = renderer.step();
        const std::vector<std::uint32_t> triangles = renderer.readSampleIds();
        const std::vector<float> lit = renderer.readVisibility();
        samples.triangles.insert(samples.triangles.end(), triangles.begin(), triangles.end());
        samples.lit.insert(samples.lit.end(), lit.begin(), lit.end());
    }
    return samples;
}

std::size_t differing(const Samples& a, const Samples& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.lit.size(); ++i) count += a.lit[i] != b.lit[i] ? 1 : 0;
    return count;
}

/// What two frames that are composed of the same instants differ by: the mean of the pixels' mean lit, and the share of
/// samples whose lit differs.
struct Apart {
    double pixels = 0.0, squared = 0.0, samples = 0.0;
};

/// Frames of the true pose at so many instants, whose shutter is closed, against the frame with so many steps at the
/// same instants and the same places in each pixel.
std::array<Apart, 2> apartAtInstants(const Scene& scene, const std::array<int, 2>& steps, int instants) {
    FramePlanner closed(scene);
    const std::unique_ptr<Technique> exact = makeTechnique("exact", sharedRenderer().programs());
    std::array<FramePlan, 2> frames;
    for (std::size_t i = 0; i < 2; ++i) frames[i] = FramePlanner(scene).plan(requestOf(32, steps[i]));
    std::array<Apart, 2> apart{};
    std::array<std::vector<double>, 2> sums;
    for (int m = 0; m < instants; ++m) {
        FrameRequest at = requestOf(1, 1);
        at.shutter.length = 0.0;
        at.frame = (m + 0.5) / instants;
        FramePlan truth = closed.plan(at);
        truth.block.seed = planAtInstant(frames[0], m, instants).block.seed;
        truth.versions.samples = truth.versions.lit = 0;
        const Samples actual = drawn(truth, *exact);
        for (std::size_t i = 0; i < 2; ++i) {
            const Samples cut = drawn(planAtInstant(frames[i], m, instants), *exact);
            apart[i].samples += static_cast<double>(differing(actual, cut)) / instants;
            sums[i].resize(actual.lit.size());
            for (std::size_t p = 0; p < actual.lit.size(); ++p)
                sums[i][p] += static_cast<double>(actual.lit[p] - cut.lit[p]) / instants;
        }
    }
    for (std::size_t i = 0; i < 2; ++i)
        for (const double difference : sums[i]) {
            apart[i].pixels += std::abs(difference);
            apart[i].squared += difference * difference;
        }
    return apart;
}

TEST(MotionSteps, DisagreementOfASpinningCubeFallsByThirty) {
    const std::unique_ptr<Scene> cube = makeSpinningCube();  // about one of its edges
    const auto [one, eight] = apartAtInstants(*cube, {1, 8}, usualOrAll(256, 1024));
    EXPECT_GT(one.pixels, 100.0) << "of 3,072 pixels";
    EXPECT_GE(one.pixels, 30.0 * eight.pixels) << one.pixels << " against " << eight.pixels;
    EXPECT_GE(one.samples, 30.0 * eight.samples) << one.samples << " against " << eight.samples;
}

/// About its own centre a cube shrinks to a point, and its shadow cannot be wrong by more than all of it: what a square
/// lacks is 2/3 of its area in the mean, and with eight steps 2/3 (1 - cos^2 11.25) of it, which is 26 times less. From
/// there on each doubling has a quarter.
TEST(MotionSteps, AboutItsCentreACubeLosesAQuarterWithEachDoubling) {
    const std::unique_ptr<Scene> cube = makeSpinningCube(glm::dvec3(0.0));
    const auto [one, eight] = apartAtInstants(*cube, {1, 8}, 128);
    EXPECT_NEAR(one.samples / eight.samples, 26.0, 8.0);
    const auto [again, sixteen] = apartAtInstants(*cube, {8, 16}, 128);
    EXPECT_EQ(again.samples, eight.samples);
    EXPECT_NEAR(eight.samples / sixteen.samples, 4.0, 1.0);
}

/// All that a technique decides of a sample depends on its place, its time and the motion there.
TEST(MotionSteps, LinearMotionIsDrawnAlike) {
    for (const unsigned seed : {1u, 2u}) {
        const auto scene = makeMovingScene({.quads = 40, .seed = seed});
        const FramePlan whole = FramePlanner(*scene).plan(requestOf(8, 1));
        ASSERT_TRUE(whole.motion.lightMoves && whole.motion.movingTriangles > 0);
        for (const std::string name : {"exact", "tsm", "accumulation"}) {
            const std::unique_ptr<Technique> technique = makeTechnique(name, sharedRenderer().programs());
            if (technique->renders() > 1) setFromText(*technique, "renders", "24");
            const Samples expected = drawn(whole, *technique);
            for (const int steps : {2, 4, 8}) {
                const FramePlan cut = FramePlanner(*scene).plan(requestOf(8, steps));
                const Samples pieces = drawn(cut, *technique);
                ASSERT_EQ(pieces.lit.size(), expected.lit.size());
                // A map's texel may round to its neighbour along an edge.
                const double most = name == "exact" ? 4e-5 : 1e-3;
                EXPECT_LE(static_cast<double>(differing(pieces, expected)),
                          most * static_cast<double>(expected.lit.size()))
                    << name << ", " << steps << " steps, seed " << seed;
            }
        }
    }
}

/// Of visibility: normals, for shading alone, are those of a piece's ends.
LinearImage pictureOf(const FramePlan& plan, Technique& technique) {
    sharedRenderer().draw(plan, technique, View::Visibility);
    return sharedRenderer().readRadiance();
}

/// Weights of all pieces make one quotient, as those of one shutter do.
TEST(MotionSteps, EveryResponseCountsAlike) {
    const auto scene = makeMovingScene({.quads = 40, .seed = 3});
    for (const auto response : {ShutterResponse::Box, ShutterResponse::Tent, ShutterResponse::Gaussian})
        for (const std::string name : {"exact", "integral", "accumulation"}) {
            const std::unique_ptr<Technique> technique = makeTechnique(name, sharedRenderer().programs());
            if (technique->renders() > 1) setFromText(*technique, "renders", "24");
            FrameRequest request = requestOf(8, 1);
            request.shutter.response = response;
            const LinearImage whole = pictureOf(FramePlanner(*scene).plan(request), *technique);
            request.motionSteps = 4;
            const LinearImage cut = pictureOf(FramePlanner(*scene).plan(request), *technique);
            std::size_t off = 0;
            for (std::size_t i = 0; i < whole.rgb.size(); ++i)
                off += std::abs(whole.rgb[i] - cut.rgb[i]) > 1e-4f * (1.0f + whole.rgb[i]) ? 1 : 0;
            EXPECT_LE(static_cast<double>(off), 2e-3 * static_cast<double>(whole.rgb.size()))
                << name << ", response " << static_cast<int>(response);
        }
}

TEST(MotionSteps, ExactAgreesWithTheOracleInEachPiece) {
    const std::unique_ptr<Scene> cube = makeSpinningCube();
    FramePlanner planner(*cube);
    const std::unique_ptr<Technique> exact = makeTechnique("exact", sharedRenderer().programs());
    for (const int steps : {1, 8}) {
        const Verification v = verifyFrame(sharedRenderer(), planner.plan(requestOf(32, steps)), *exact, {});
        EXPECT_EQ(v.samples, 64u * 48u * 32u);
        EXPECT_GT(v.shadowed, 1000u);
        EXPECT_LE(v.ppm(), 10.0) << steps;
        EXPECT_EQ(v.primaryDisagree, 0u) << steps;
    }
}

/// Both references are those of the pieces: a picture is near that of its own steps and far from that of one.
TEST(MotionSteps, ReferencesHaveThemToo) {
    const std::unique_ptr<Scene> cube = makeSpinningCube();
    FramePlanner planner(*cube);
    const FramePlan one = planner.plan(requestOf(32, 1)), eight = planner.plan(requestOf(32, 8));
    const std::unique_ptr<Technique> exact = makeTechnique("exact", sharedRenderer().programs());
    const auto folder = std::filesystem::temp_directory_path() / "timeshade-motion-steps-test";
    std::filesystem::remove_all(folder);
    ReferenceCache cache(folder);
    const auto errorAgainst = [&](const FramePlan& plan) {
        VerificationOptions how;
        how.checkPrimaries = false;
        how.reference = referenceVisibility(plan, 256, cache);
        return verifyFrame(sharedRenderer(), eight, *exact, how).shadowError->error.rms;
    };
    const double own = errorAgainst(eight), other = errorAgainst(one);
    EXPECT_LT(own, 0.03);
    EXPECT_GT(other, 3.0 * own);
    ReferenceOptions options;
    options.samplesPerPixel = 128;
    options.view = View::Visibility;
    const auto rms = [&](const FramePlan& plan) {
        const LinearImage reference = referenceImage(sharedRenderer(), plan, options, cache);
        const LinearImage picture = [&] {
            sharedRenderer().draw(eight, *exact, View::Visibility);
            return sharedRenderer().readRadiance();
        }();
        double sum = 0.0;
        for (std::size_t i = 0; i < picture.rgb.size(); ++i)
            sum += std::pow(static_cast<double>(picture.rgb[i] - reference.rgb[i]), 2);
        return std::sqrt(sum / static_cast<double>(picture.rgb.size()));
    };
    const double near = rms(eight), far = rms(one);
    EXPECT_LT(near, 0.04);
    EXPECT_GT(far, 3.0 * near);
    std::filesystem::remove_all(folder);
}

TEST(MotionSteps, EveryTechniqueDrawsThemOrRefuses) {
    const std::unique_ptr<Scene> cube = makeSpinningCube();
    FramePlanner planner(*cube);
    const FramePlan plan = planner.plan(requestOf(8, 4));
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        const std::unique_ptr<Technique> technique = makeTechnique(description.name, sharedRenderer().programs());
        if (technique->renders() > 1) setFromText(*technique, "renders", "8");
        if (const auto reason = technique->unsupported(plan)) {
            EXPECT_NE(reason->find("--motion-steps 1"), std::string::npos) << *reason;
            EXPECT_THROW(sharedRenderer().draw(plan, *technique, View::Final), Error);
            continue;
        }
        sharedRenderer().draw(plan, *technique, View::Final);
        const LinearImage first = sharedRenderer().readRadiance();
        sharedRenderer().draw(plan, *technique, View::Final);
        EXPECT_EQ(sharedRenderer().readRadiance().rgb, first.rgb) << description.name;
    }
}

}  // namespace
}  // namespace timeshade
