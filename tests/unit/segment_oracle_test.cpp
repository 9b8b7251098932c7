// What a position of the image sees when, against the oracle's own rays at many instants of it, and on scenes whose
// segments are known.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cases/procedural_scene.h"
#include "oracle/camera_rays.h"
#include "oracle/resolve_primary.h"
#include "oracle/seen_segments.h"
#include "oracle/segment_oracle.h"
#include "scene_catalogue.h"

namespace timeshade {
namespace {

using glm::dvec3;
using glm::vec2;
using Segments = std::vector<SeenSegment>;

/// With TIMESHADE_MANY set: a hundred times as many.
int many(int usual) { return std::getenv("TIMESHADE_MANY") != nullptr ? 100 * usual : usual; }

/// A partition of the shutter, in order, whose neighbours differ.
void expectPartition(const Segments& segments) {
    ASSERT_FALSE(segments.empty());
    EXPECT_EQ(segments.front().u0, 0.0);
    EXPECT_EQ(segments.back().u1, 1.0);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        EXPECT_GE(segments[i].u1 - segments[i].u0, 0x1p-40);
        if (i == 0) continue;
        EXPECT_EQ(segments[i].u0, segments[i - 1].u1);
        EXPECT_NE(segments[i].triangle, segments[i - 1].triangle);
    }
}

/// The oracle's rays at instants.
class Instants {
  public:
    explicit Instants(const FramePlan& plan) : plan_(plan), triangles_(plan.texels->positions), bvh_(triangles_) {}

    struct Tally {
        long positions = 0, segments = 0, still = 0, instants = 0, margins = 0, different = 0;
        long sides = 0, otherSides = 0;  ///< instants close to a change, and those that see another triangle
        void add(const Tally& t) {
            positions += t.positions;
            segments += t.segments;
            still += t.still;
            instants += t.instants;
            margins += t.margins;
            different += t.different;
            sides += t.sides;
            otherSides += t.otherSides;
        }
    };

    void compare(vec2 place, const Segments& segments, std::mt19937& random, Tally& tally) const {
        ++tally.positions;
        tally.segments += static_cast<long>(segments.size());
        tally.still += segments.size() == 1 ? 1 : 0;
        std::uniform_real_distribution<float> any(0.0f, 1.0f);
        for (int i = 0; i < 16; ++i) at(place, segments, any(random), tally);
        const oracle::PositionRay ray = oracle::positionRay(plan_, place, glm::dvec2(0.0));
        for (const SeenSegment& s : segments) {
            for (const double by : {-1e-3, -1e-4, 1e-4, 1e-3})
                at(place, segments, static_cast<float>(s.u0 + by), tally);
            if (s.u1 - s.u0 < 1e-8) continue;
            for (const double u : {s.u0 + 1e-9, s.u1 - 1e-9}) {
                ++tally.sides;
                tally.otherSides += seenAt(oracle::rayAt(ray, u)).triangle == s.triangle ? 0 : 1;
            }
        }
    }

  private:
    Oracle::ResolvedPrimary seenAt(const oracle::CameraRay& ray) const {
        return oracle::resolveFirstSeen(bvh_, triangles_, ray, static_cast<double>(plan_.camera.block.nearDistance));
    }
    void at(vec2 place, const Segments& segments, float u, Tally& tally) const {
        const auto time = static_cast<double>(u);
        if (!(time >= 0.0 && time <= 1.0)) return;
        const auto seen = std::find_if(segments.begin(), segments.end(),
                                       [&](const SeenSegment& s) { return s.u0 <= time && time <= s.u1; });
        ASSERT_NE(seen, segments.end());
        const Oracle::ResolvedPrimary truth = seenAt(oracle::cameraRayThrough(plan_, place, u));
        ++tally.instants;
        tally.margins += truth.marginal ? 1 : 0;
        if (truth.triangle == seen->triangle || truth.marginal) return;
        if (tally.different++ == 0)
            ADD_FAILURE() << "at " << place.x << ", " << place.y << " the time " << u << " sees " << truth.triangle
                          << ", not " << seen->triangle << " of [" << seen->u0 << ", " << seen->u1 << "]";
    }

    const FramePlan& plan_;
    oracle::MovingTriangles triangles_;
    oracle::SweptBvh bvh_;
};

/// Random places of a plan's image against instants.
Instants::Tally compareWithInstants(const FramePlan& plan, int places, std::uint32_t seed) {
    const SegmentOracle oracle(plan);
    const Instants instants(plan);
    std::mt19937 random(seed);
    std::vector<vec2> all;
    for (int i = 0; i < places; ++i) {
        const glm::vec2 size(plan.camera.block.size);
        std::uniform_real_distribution<float> x(0.0f, size.x), y(0.0f, size.y);
        const float left = x(random), low = y(random);
        all.emplace_back(left, low);
    }
    const std::vector<Segments> seen = oracle.seenByAll(plan, all);
    Instants::Tally tally;
    for (std::size_t i = 0; i < all.size(); ++i) {
        expectPartition(seen[i]);
        instants.compare(all[i], seen[i], random, tally);
    }
    return tally;
}

void report(const std::string& name, const Instants::Tally& t) {
    std::printf(
        "%s: %ld places, %.3f segments each, %ld with one; %ld instants, %ld within rounding; 1e-9 beside "
        "changes %ld of %ld differ\n",
        name.c_str(), t.positions, static_cast<double>(t.segments) / static_cast<double>(t.positions), t.still,
        t.instants, t.margins, t.otherSides, t.sides);
}

/// Quadrilaterals, not flat, that fly, turn and pass through one another and past the camera.
class RandomScene {
  public:
    RandomScene(std::uint32_t seed, bool cameraMoves, bool twoSided) : random_(seed) {
        for (int i = 0; i < 50; ++i) addQuad(i);
        scene_.cameraOpen = lookAt({0.3, 0.4, 6.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.9, 0.5);
        scene_.cameraClose = scene_.cameraOpen;
        if (cameraMoves) scene_.cameraClose = lookAt({0.8, 0.1, 5.5}, {0.5, -0.4, 0.0}, {0.1, 1.0, 0.0}, 0.9, 0.5);
        scene_.lightOpen.position = scene_.lightClose.position = {2.0, 7.0, 3.0};
        scene_.finish();
        planner_ = std::make_unique<FramePlanner>(scene_);
        plan = planner_->plan(ProceduralScene::request(320, 240, 4, 64, seed));
        if (!twoSided) return;
        auto texels = std::make_shared<MeshTexels>(*plan.texels);
        for (std::size_t t = 0; t < texels->positions.size() / TRIANGLE_POSITION_TEXELS; t += 2)
            texels->positions[t * TRIANGLE_POSITION_TEXELS + 4].z = 1.0f;
        plan.texels = texels;
    }

    FramePlan plan;

  private:
    dvec3 within(double r) {
        std::uniform_real_distribution<double> any(-r, r);
        const double x = any(random_), y = any(random_), z = any(random_);
        return {x, y, z};
    }
    void addQuad(int i) {
        const double size = i % 7 == 0 ? 2.5 : 0.2 + 0.6 * std::abs(within(1.0).x);
        const dvec3 centre = within(2.5) + (i % 11 == 0 ? dvec3(0.0, 0.0, 3.5) : dvec3(0.0));
        const dvec3 move = i % 3 == 0 ? dvec3(0.0) : within(1.5);
        const dvec3 corners[4] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
        MovingQuad quad{};
        for (int c = 0; c < 4; ++c) {
            quad.open[c] = centre + size * corners[c] + within(0.5 * size);
            quad.close[c] = quad.open[c] + move + (i % 2 == 0 ? dvec3(0.0) : within(0.5 * size));
        }
        // Some turn their back to the camera during the shutter.
        if (i % 5 == 0) std::swap(quad.close[0], quad.close[1]), std::swap(quad.close[2], quad.close[3]);
        scene_.quads.push_back(quad);
    }

    std::mt19937 random_;
    ProceduralScene scene_;
    std::unique_ptr<FramePlanner> planner_;
};

TEST(SegmentOracle, AgreesWithInstantsOfRandomScenes) {
    Instants::Tally sum;
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        const RandomScene scene(seed, seed % 2 == 1, seed % 4 >= 2);
        sum.add(compareWithInstants(scene.plan, many(400), seed));
    }
    report("random scenes", sum);
    EXPECT_EQ(sum.different, 0);
    EXPECT_GT(sum.segments, 3 * sum.positions);
    EXPECT_LT(sum.margins, sum.instants / 50);
    EXPECT_LE(sum.otherSides, sum.sides / 1000);
}

struct Moment {
    const char* scene;
    double frame;
    long changes;  ///< at least so many are met
};
class SegmentOracleScenes : public testing::TestWithParam<Moment> {};

TEST_P(SegmentOracleScenes, AgreesWithInstants) {
    const std::unique_ptr<Scene> scene = openScene(GetParam().scene, "");
    FrameRequest request;
    request.width = 320;
    request.height = 240;
    request.frame = GetParam().frame;
    const FramePlan plan = FramePlanner(*scene).plan(request);
    const Instants::Tally tally = compareWithInstants(plan, many(4000), 7);
    report(GetParam().scene, tally);
    EXPECT_EQ(tally.different, 0);
    EXPECT_GT(tally.segments, tally.positions + GetParam().changes);
    EXPECT_LT(tally.margins, tally.instants / 10);  // flat walls of many triangles
    EXPECT_LE(tally.otherSides, tally.sides / 1000);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SegmentOracleScenes,
                         testing::Values(Moment{"chess", 20.0, 500}, Moment{"octopus", 96.0, 500},
                                         Moment{"pillars", 11.0, -1}, Moment{"cubes", 0.0, 1000}),
                         [](const auto& moment) { return std::string(moment.param.scene); });

}  // namespace
}  // namespace timeshade
