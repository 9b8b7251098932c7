// `integral` on real scenes: each stratum's mean against the union of shadowed times in double precision, by code of
// its own, over all triangles; and the same value whatever the grid, bit by bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "oracle/oracle.h"
#include "scene_catalogue.h"
#include "shared/segment_triangle.shared.h"
#include "support/drawn_here.h"
#include "support/gl_environment.h"
#include "support/moving_scene.h"
#include "support/shadowed_times.h"
#include "support/thorough.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

using glm::dvec3;
using Interval = ShadowedTimes::Interval;

/// The light, the casters and a followed receiver of a plan, in double precision.
class World {
  public:
    explicit World(const FramePlan& plan) : plan_(plan), oracle_(plan) {}

    struct Truth {
        bool tested = false;
        double lit = 1.0;
        double spread = 0.0;  ///< how far that changes where the receiver is rounded as its clearance allows for
    };
    /// Over [from, to] of the shutter.
    Truth truth(SampleIndex sample, std::uint32_t triangle, double from, double to) const {
        const OracleAnswer seen = oracle_.resolve(plan_, sample, triangle);
        if (!seen.tested || seen.marginal) return {};
        const dvec3 p[2] = {oracle_.followed(triangle, seen.position, static_cast<double>(seen.time), from),
                            oracle_.followed(triangle, seen.position, static_cast<double>(seen.time), to)};
        Truth truth{true, litOf(triangle, p, from, to), 0.0};
        if (truth.lit < 0.0) return {};
        const double rounding = clearanceOf(triangle, 0.5 * (from + to));
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {-1.0, 1.0}) {
                dvec3 by(0.0);
                by[axis] = sign * rounding;
                const dvec3 moved[2] = {p[0] + by, p[1] + by};
                truth.spread = std::max(truth.spread, std::abs(litOf(triangle, moved, from, to) - truth.lit));
            }
        return truth;
    }

  private:
    /// Negative where hardly any of the time is tested.
    double litOf(std::uint32_t triangle, const dvec3 (&p)[2], double from, double to) const {
        std::vector<Interval> dark = untested(triangle, p, from, to);
        const double tested = 1.0 - ShadowedTimes::measure(dark);
        if (tested < 1e-3) return -1.0;
        for (std::uint32_t id = 0; id < plan_.mesh->topology->triangles.size(); ++id) {
            if (id == triangle || !mayReach(id, p, from, to)) continue;
            for (const Interval& i : ShadowedTimes(motionOf(id, triangle, p, from, to)).intervals()) dark.push_back(i);
        }
        return (1.0 - ShadowedTimes::measure(dark)) / tested;
    }
    double clearanceOf(std::uint32_t id, double u) const {
        return static_cast<double>(shared::receiverClearance(glm::vec3(vertex(id, 0, u)), glm::vec3(vertex(id, 1, u)),
                                                             glm::vec3(vertex(id, 2, u))));
    }
    static dvec3 mixed(const glm::vec4& a, const glm::vec4& b, double u) { return glm::mix(dvec3(a), dvec3(b), u); }
    dvec3 toLight(const dvec3& p, double u) const {
        const shared::FrameBlock& f = plan_.block;
        if (f.lightDirection.w != 0.0f)
            return -mixed(f.lightDirection, f.lightDirectionClose, u) *
                   static_cast<double>(plan_.light.block.farDistance);
        return mixed(f.lightPositionOpen, f.lightPositionClose, u) - p;
    }
    dvec3 vertex(std::uint32_t id, int corner, double u) const {
        const std::uint32_t v = plan_.mesh->topology->triangles[id][corner];
        return glm::mix(dvec3(plan_.texels->vertices[2 * v]), dvec3(plan_.texels->vertices[2 * v + 1]), u);
    }
    /// False where no time of the interval brings the triangle between the receiver and the light: seen along the
    /// light.
    bool mayReach(std::uint32_t id, const dvec3 (&p)[2], double from, double to) const {
        const dvec3 ends[4] = {p[0], p[1], p[0] + toLight(p[0], from), p[1] + toLight(p[1], to)};
        const dvec3 along = ends[2] - ends[0];
        const dvec3 across = glm::cross(along, std::abs(along.x) < std::abs(along.z) ? dvec3(1, 0, 0) : dvec3(0, 0, 1));
        for (const dvec3& axis : {across, glm::cross(along, across), along}) {
            double low = 1e300, high = -1e300, least = 1e300, most = -1e300;
            for (const dvec3& end : ends) {
                low = std::min(low, glm::dot(axis, end));
                high = std::max(high, glm::dot(axis, end));
            }
            for (int corner = 0; corner < 3; ++corner)
                for (const double u : {from, to}) {
                    const double d = glm::dot(axis, vertex(id, corner, u));
                    least = std::min(least, d);
                    most = std::max(most, d);
                }
            if (least > high || most < low) return false;
        }
        return true;
    }
    ShadowedTimes::Motion motionOf(std::uint32_t id, std::uint32_t own, const dvec3 (&p)[2], double from,
                                   double to) const {
        ShadowedTimes::Motion m;
        const double times[2] = {from, to};
        for (int end = 0; end < 2; ++end) {
            m.light[end] = toLight(p[end], times[end]);
            for (int corner = 0; corner < 3; ++corner)
                m.vertices[corner][end] = vertex(id, corner, times[end]) - p[end];
        }
        m.clearance = clearanceOf(own, 0.5 * (from + to));
        return m;
    }
    bool isTested(std::uint32_t id, const dvec3 (&p)[2], double u, double t) const {
        const dvec3 place = glm::mix(p[0], p[1], t), l = toLight(place, u);
        const dvec3 a = vertex(id, 0, u);
        dvec3 normal = glm::cross(vertex(id, 1, u) - a, vertex(id, 2, u) - a);
        const dvec3 eye = mixed(plan_.block.cameraPositionOpen, plan_.block.cameraPositionClose, u);
        const bool twoSided = plan_.texels->positions[std::size_t{id} * TRIANGLE_POSITION_TEXELS + 4].z != 0.0f;
        if (twoSided && glm::dot(a - eye, normal) > 0.0) normal = -normal;
        const shared::FrameBlock& f = plan_.block;
        const dvec3 axis = glm::normalize(mixed(f.lightDirection, f.lightDirectionClose, u));
        const bool inCone =
            f.lightDirection.w != 0.0f || glm::dot(-l, axis) >= static_cast<double>(f.lightCone.x) * glm::length(l);
        return inCone && glm::dot(normal, l) > 0.0;
    }
    std::vector<Interval> untested(std::uint32_t id, const dvec3 (&p)[2], double from, double to) const {
        constexpr int parts = 64;
        const auto is = [&](double t) { return isTested(id, p, from + t * (to - from), t); };
        std::vector<Interval> found;
        double begin = is(0.0) ? -1.0 : 0.0;
        for (int k = 1; k <= parts; ++k) {
            double low = (k - 1.0) / parts, high = double(k) / parts;
            const bool before = begin < 0.0;
            if (is(high) == before) continue;
            for (int i = 0; i < 50; ++i) (is(0.5 * (low + high)) == before ? low : high) = 0.5 * (low + high);
            if (!before) found.emplace_back(begin, high);
            begin = before ? high : -1.0;
        }
        if (begin >= 0.0) found.emplace_back(begin, 1.0);
        return found;
    }

    const FramePlan& plan_;
    Oracle oracle_;
};

/// A scene, and a frame in which something passes.
struct Moment {
    const char* scene;
    double frame;
};
class Integral : public DrawnHere<Moment> {};

TEST_P(Integral, IsTheUnionInDoublePrecision) {
    const std::unique_ptr<Scene> scene = openScene(GetParam().scene, "");
    FrameRequest request;
    request.width = 160;
    request.height = 120;
    request.samplesPerPixel = 4;
    request.mapSize = 256;
    request.frame = GetParam().frame;
    const FramePlan plan = FramePlanner(*scene).plan(request);
    const std::unique_ptr<Technique> technique = makeTechnique("integral", sharedRenderer().programs());
    sharedRenderer().draw(plan, *technique, View::Visibility);
    const std::vector<float> lit = sharedRenderer().readVisibility();
    const std::vector<std::uint32_t> ids = sharedRenderer().readSampleIds();
    const World world(plan);
    const std::size_t everyPartly = usualOrAll(17u, 5u), everyOther = usualOrAll(97u, 61u);
    double sum = 0.0, of = 0.0, large = 0.0, worst = 0.0;
    int compared = 0, partly = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        // Most are all lit or all dark: of the others more are taken.
        const bool isPartly = lit[i] > 0.0f && lit[i] < 1.0f;
        if (ids[i] == NO_TRIANGLE || i % (isPartly ? everyPartly : everyOther) != 0) continue;
        const auto pixels = std::size_t{160} * 120;
        const SampleIndex sample{static_cast<std::uint32_t>(i % 160), static_cast<std::uint32_t>(i % pixels / 160),
                                 static_cast<std::uint32_t>(i / pixels)};
        const double from =
            static_cast<double>(plan.block.timeBase + static_cast<float>(sample.stratum) * plan.block.timeScale);
        const World::Truth truth = world.truth(sample, ids[i], from, from + static_cast<double>(plan.block.timeScale));
        if (!truth.tested) continue;
        const double error = std::abs(static_cast<double>(lit[i]) - truth.lit);
        EXPECT_LE(error, 3e-5 + 1.5 * truth.spread) << "sample " << i << ": " << lit[i] << " for " << truth.lit;
        ++compared;
        partly += truth.lit > 1e-6 && truth.lit < 1.0 - 1e-6;
        const auto stands = static_cast<double>(isPartly ? everyPartly : everyOther);  // for so many samples
        of += stands;
        sum += stands * error;
        large += error > 1e-4 ? stands : 0.0;
        worst = std::max(worst, error);
    }
    std::printf("%s: %d samples, %d of them partly lit, mean error %.2e, worst %.2e, %.0f ppm above 1e-4\n",
                GetParam().scene, compared, partly, sum / of, worst, 1e6 * large / of);
    EXPECT_GT(compared, 500);
    EXPECT_GT(partly, 5);
    EXPECT_LE(sum / of, 3e-6);  // most of it from the rounding of receivers
}

INSTANTIATE_TEST_SUITE_P(Scenes, Integral,
                         testing::Values(Moment{"chess", 20.0}, Moment{"octopus", 96.0}, Moment{"pillars", 11.0},
                                         Moment{"cubes", 0.0}),
                         [](const auto& p) { return std::string(p.param.scene); });

struct Kind {
    const char* name;
    bool cameraTurns, directional;
};
class IntegralLists : public testing::TestWithParam<Kind> {};

/// The pieces of a way are those of its cells, so that ends are rounded otherwise: by some ticks, more where an edge
/// hardly moves (1.4e-4 seen).
TEST_P(IntegralLists, GridChangesNothing) {
    const std::unique_ptr<ProceduralScene> scene = makeMovingScene(
        {.quads = 40, .seed = 9, .cameraTurns = GetParam().cameraTurns, .directionalLight = GetParam().directional});
    const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(96, 72, 4, 256, 9));
    std::vector<float> first;
    int grid = 0;
    for (const char* side : {"64", "1", "7", "200", "1024"})
        for (const char* buckets : {"1", "3", "32"}) {
            if (usualOrAll(grid++ % 4, 0) != 0) continue;
            const std::unique_ptr<Technique> technique = makeTechnique("integral", sharedRenderer().programs());
            setFromText(*technique, "side", side);
            setFromText(*technique, "buckets", buckets);
            sharedRenderer().draw(plan, *technique, View::Visibility);
            const std::vector<float> lit = sharedRenderer().readVisibility();
            if (first.empty()) first = lit;
            double worst = 0.0, sum = 0.0;
            for (std::size_t i = 0; i < lit.size(); ++i) {
                const double error = std::abs(static_cast<double>(lit[i] - first[i]));
                worst = std::max(worst, error);
                sum += error;
            }
            EXPECT_LE(worst, 1e-3) << "side " << side << ", buckets " << buckets;
            EXPECT_LE(sum / static_cast<double>(lit.size()), 1e-7) << "side " << side << ", buckets " << buckets;
        }
}

INSTANTIATE_TEST_SUITE_P(Kinds, IntegralLists,
                         testing::Values(Kind{"camera_moves", false, false}, Kind{"camera_turns", true, false},
                                         Kind{"sun", false, true}),
                         [](const auto& p) { return std::string(p.param.name); });

}  // namespace
}  // namespace timeshade
