// The oracle's two halves against each other and against a third: Embree in floats, samples resolved over their own
// hierarchy in exact arithmetic, and every triangle tried in turn by the textbook. They may differ only where the
// exact half says that a float's rounding decides.
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "cases/procedural_scene.h"
#include "oracle/camera_rays.h"
#include "oracle/oracle.h"
#include "oracle/resolve_shadow.h"
#include "scene/camera.h"

namespace timeshade {
namespace {

struct Options {
    bool directional = false;
    bool twoSided = false;  ///< every other triangle
};

/// Quads of all sizes that fly, turn and deform above a floor; a light and a camera that move, the camera turning too.
class RandomFrame {
  public:
    explicit RandomFrame(std::uint32_t seed, Options options = {}) : random_(seed) {
        scene_.quads.push_back(slidingQuad({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 6.0, -6.0, 6.0));
        for (int i = 0; i < 40; ++i) addQuad();
        scene_.cameraOpen = lookAt({1.0, -9.0, 8.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, 0.8, 0.5);
        scene_.cameraClose = lookAt({0.2, -9.3, 7.5}, {0.4, 0.1, 1.2}, {0.1, 0.0, 1.0}, 0.8, 0.5);
        scene_.lightOpen = light(options.directional);
        scene_.lightClose = scene_.lightOpen;
        scene_.lightClose.position += glm::dvec3(2.0, 1.0, -1.0);
        scene_.finish();
        planner_ = std::make_unique<FramePlanner>(scene_);
        plan =
            planner_->plan(ProceduralScene::request(93, 70, 4, 256, seed));  // rows that do not fill their last packet
        if (options.twoSided) {
            auto texels = std::make_shared<MeshTexels>(*plan.texels);
            for (std::size_t t = 0; t < texels->positions.size() / TRIANGLE_POSITION_TEXELS; t += 2)
                texels->positions[t * TRIANGLE_POSITION_TEXELS + 4].z = 1.0f;
            plan.texels = texels;
        }
    }

    FramePlan plan;

  private:
    double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    glm::dvec3 point(double r) { return {number(-r, r), number(-r, r), number(-r, r)}; }

    void addQuad() {
        const double size = 0.05 + 0.8 * number(0.0, 1.0);
        const glm::dvec3 centre = point(3.0) * glm::dvec3(1.0, 1.0, 0.8) + glm::dvec3(0.0, 0.0, 3.0), move = point(1.0);
        const glm::dvec3 a = size * glm::normalize(point(1.0)), b = size * glm::normalize(point(1.0));
        MovingQuad quad{{centre - a - b, centre + a - b, centre + a + b, centre - a + b}, {}};
        for (int c = 0; c < 4; ++c) quad.close[c] = quad.open[c] + move + point(0.4 * size);
        scene_.quads.push_back(quad);
    }

    static LightPose light(bool directional) {
        LightPose pose;
        pose.kind = directional ? LightKind::Directional : LightKind::Spot;
        pose.position = {-1.0, -0.5, 12.0};
        pose.axes = lookAt(pose.position, {0.0, 0.3, 0.0}, {0.0, 1.0, 0.0}, 0.8, 0.1).axes;
        pose.outerConeAngle = 0.45;
        return pose;
    }

    std::mt19937 random_;
    ProceduralScene scene_;
    std::unique_ptr<FramePlanner> planner_;
};

/// Spots and directional lights, one-sided and two-sided, in turn.
Options optionsOf(std::uint32_t seed) { return {seed % 2 == 1, seed % 4 >= 2}; }

template <class Visit>
void forEachSample(const FramePlan& plan, const Visit& visit) {
    std::size_t i = 0;
    for (std::uint32_t k = 0; k < plan.block.strata; ++k)
        for (std::uint32_t y = 0; y < plan.block.imageSize.y; ++y)
            for (std::uint32_t x = 0; x < plan.block.imageSize.x; ++x) visit(SampleIndex{x, y, k}, i++);
}

struct Tally {
    std::size_t tested = 0, shadowed = 0, marginal = 0, different = 0, differentForSure = 0;
};

Tally tallyOf(const std::vector<OracleAnswer>& answers, const std::vector<OracleAnswer>& resolved) {
    Tally tally;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        EXPECT_EQ(answers[i].hit, resolved[i].hit);
        EXPECT_EQ(answers[i].tested, resolved[i].tested);
        EXPECT_EQ(answers[i].position, resolved[i].position);
        if (!resolved[i].tested) continue;
        ++tally.tested;
        tally.shadowed += resolved[i].lit ? 0u : 1u;
        tally.marginal += resolved[i].marginal ? 1u : 0u;
        const bool different = answers[i].lit != resolved[i].lit;
        tally.different += different ? 1u : 0u;
        tally.differentForSure += different && !resolved[i].marginal ? 1u : 0u;
    }
    return tally;
}

TEST(OracleAgreement, EmbreeDiffersFromExactArithmeticOnlyOnMargins) {
    Tally sum;
    for (std::uint32_t seed = 0; seed < 24; ++seed) {
        const RandomFrame frame(seed, optionsOf(seed));
        const Oracle oracle(frame.plan);
        const std::vector<std::uint32_t> ids = oracle.tracePrimaries(frame.plan);
        const Tally tally = tallyOf(oracle.answer(frame.plan, ids), oracle.resolveAll(frame.plan, ids));
        sum.tested += tally.tested;
        sum.shadowed += tally.shadowed;
        sum.marginal += tally.marginal;
        sum.different += tally.different;
        sum.differentForSure += tally.differentForSure;
        EXPECT_EQ(tally.differentForSure, 0u) << "scene " << seed;
    }
    RecordProperty("tested", static_cast<int>(sum.tested));
    RecordProperty("different", static_cast<int>(sum.different));
    RecordProperty("marginal", static_cast<int>(sum.marginal));
    EXPECT_GT(sum.tested, 250000u);
    EXPECT_GT(sum.shadowed, sum.tested / 10);
    EXPECT_LE(sum.different, sum.tested / 100000);
    EXPECT_LE(sum.marginal, sum.tested / 1000);
}

TEST(OracleAgreement, EmbreeSeesWhatExactArithmeticSees) {
    std::size_t samples = 0, different = 0, marginal = 0;
    for (std::uint32_t seed = 0; seed < 16; ++seed) {
        RandomFrame frame(seed, optionsOf(seed));
        if (seed % 3 == 0) frame.plan.camera.block.nearDistance = 9.0f;  // cuts through the flying quads
        const Oracle oracle(frame.plan);
        const std::vector<std::uint32_t> ids = oracle.tracePrimaries(frame.plan);
        std::size_t seen = 0;
        forEachSample(frame.plan, [&](SampleIndex sample, std::size_t i) {
            const Oracle::ResolvedPrimary resolved = oracle.resolvePrimary(frame.plan, sample);
            ++samples;
            seen += ids[i] != NO_TRIANGLE ? 1u : 0u;
            marginal += resolved.marginal ? 1u : 0u;
            different += resolved.triangle != ids[i] ? 1u : 0u;
            EXPECT_TRUE(resolved.marginal || resolved.triangle == ids[i]) << "scene " << seed << ", sample " << i;
        });
        EXPECT_GT(seen, ids.size() / 2);
    }
    RecordProperty("different", static_cast<int>(different));
    EXPECT_LE(different, samples / 20000);
    EXPECT_LE(marginal, samples / 500);
}

/// Moeller and Trumbore 1997, with barycentric coordinates, on every triangle.
bool shadowedByTextbook(const FramePlan& plan, const OracleAnswer& receiver, const glm::dvec3& light,
                        std::uint32_t own) {
    const oracle::MovingTriangles triangles(plan.texels->positions);
    const glm::dvec3 d = light - receiver.position;
    double clearance = 0.0;
    glm::dvec3 receiving[3];
    triangles.at(own, static_cast<double>(receiver.time), receiving);
    for (const glm::dvec3& v : receiving)
        clearance = std::max({clearance, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    clearance = std::ldexp(clearance, -21);
    for (std::uint32_t id = 0; id < triangles.count(); ++id) {
        glm::dvec3 v[3];
        triangles.at(id, static_cast<double>(receiver.time), v);
        const glm::dvec3 a = v[1] - v[0], b = v[2] - v[0], h = glm::cross(d, b), s = receiver.position - v[0],
                         q = glm::cross(s, a);
        const double determinant = glm::dot(a, h), u = glm::dot(s, h) / determinant, w = glm::dot(d, q) / determinant,
                     t = glm::dot(b, q) / determinant;
        const glm::dvec3 normal = glm::cross(a, b);
        const bool clear = std::abs(glm::dot(s, normal)) > clearance * glm::length(normal);
        if (id != own && u >= 0.0 && w >= 0.0 && u + w <= 1.0 && t > 0.0 && t < 1.0 && clear) return true;
    }
    return false;
}

TEST(OracleAgreement, ExactArithmeticIsTheDefinition) {
    for (std::uint32_t seed = 100; seed < 104; ++seed) {
        const RandomFrame frame(seed, optionsOf(seed));
        const Oracle oracle(frame.plan);
        const std::vector<std::uint32_t> ids = oracle.tracePrimaries(frame.plan);
        const std::vector<OracleAnswer> resolved = oracle.resolveAll(frame.plan, ids);
        std::size_t compared = 0;
        forEachSample(frame.plan, [&](SampleIndex sample, std::size_t i) {
            if (!resolved[i].tested || resolved[i].marginal) return;
            ++compared;
            const glm::dvec3 light =
                oracle::lightEnd(frame.plan, resolved[i].position, static_cast<double>(resolved[i].time));
            EXPECT_EQ(resolved[i].lit, !shadowedByTextbook(frame.plan, resolved[i], light, ids[i]));
            const OracleAnswer again = oracle.resolve(frame.plan, sample, ids[i]);
            EXPECT_EQ(again.lit, resolved[i].lit);
        });
        EXPECT_GT(compared, 5000u);
    }
}

TEST(OracleAgreement, ReceiversLieOnTheirTriangleAndUnderTheirPixel) {
    const RandomFrame frame(7, {false, true});
    const FramePlan& plan = frame.plan;
    const Oracle oracle(plan);
    const std::vector<std::uint32_t> ids = oracle.tracePrimaries(plan);
    const std::vector<OracleAnswer> answers = oracle.answer(plan, ids);
    const oracle::MovingTriangles triangles(plan.texels->positions);
    std::size_t facingBoth = 0;
    forEachSample(plan, [&](SampleIndex sample, std::size_t i) {
        const OracleAnswer& answer = answers[i];
        ASSERT_EQ(answer.hit, ids[i] != NO_TRIANGLE);
        const double u = static_cast<double>(answer.time);
        ASSERT_GE(u * plan.block.strata, sample.stratum - 1e-6);
        ASSERT_LE(u * plan.block.strata, sample.stratum + 1 + 1e-6);
        if (!answer.hit) return;
        glm::dvec3 v[3];
        triangles.at(ids[i], u, v);
        const glm::dvec3 normal = glm::normalize(glm::cross(v[1] - v[0], v[2] - v[0]));
        ASSERT_NEAR(glm::dot(normal, answer.position - v[0]), 0.0, 1e-11);
        const glm::dmat3 rays =
            glm::dmat3(plan.camera.open.right, plan.camera.open.up, plan.camera.open.corner) * (1.0 - u) +
            glm::dmat3(plan.camera.close.right, plan.camera.close.up, plan.camera.close.corner) * u;
        const glm::dvec3 eye = glm::mix(plan.camera.open.eye, plan.camera.close.eye, u);
        const glm::dvec3 place = glm::inverse(rays) * (answer.position - eye);
        ASSERT_GT(place.z, static_cast<double>(plan.camera.block.nearDistance));
        // Half a pixel around its centre, and what floats of this size round by.
        ASSERT_NEAR(place.x / place.z * plan.block.imageSize.x, sample.x + 0.5, 0.5 + 1e-4);
        ASSERT_NEAR(place.y / place.z * plan.block.imageSize.y, sample.y + 0.5, 0.5 + 1e-4);
        // Design: facing follows the winding; two-sided triangles are flipped towards the camera.
        const bool behind = glm::dot(normal, eye - answer.position) < 0.0;
        ASSERT_TRUE(!behind || triangles.doubleSided(ids[i]) || oracle.resolvePrimary(plan, sample).marginal);
        const glm::dvec3 l = oracle::lightEnd(plan, answer.position, u) - answer.position;
        const bool faces = glm::dot(behind ? -normal : normal, l) > 0.0;
        const bool inCone =
            std::acos(glm::dot(glm::normalize(l), plan.lightOpen.axes[2])) <= plan.lightOpen.outerConeAngle;
        ASSERT_TRUE(answer.tested == (faces && inCone) || answer.marginal);
        facingBoth += behind ? 1u : 0u;
    });
    EXPECT_GT(facingBoth, 100u);
}

TEST(OracleAgreement, DirectionalSegmentsLeadPastTheScene) {
    const RandomFrame frame(11, {true, false});
    const glm::dvec3 back = frame.plan.lightOpen.axes[2];
    double lowest = 1e300, highest = -1e300;
    for (const glm::vec3& vertex : frame.plan.texels->vertices) {
        lowest = std::min(lowest, glm::dot(back, glm::dvec3(vertex)));
        highest = std::max(highest, glm::dot(back, glm::dvec3(vertex)));
    }
    EXPECT_GT(glm::dot(back, oracle::lightEnd(frame.plan, back * lowest, 0.3)), highest);
}

TEST(OracleAgreement, InstantsOfTheSameFrame) {
    const RandomFrame frame(3);
    const Oracle oracle(frame.plan);
    for (const int m : {0, 2, 4}) {
        const FramePlan instant = planAtInstant(frame.plan, m, 5);
        const std::vector<std::uint32_t> ids = oracle.tracePrimaries(instant);
        ASSERT_EQ(ids.size(), std::size_t{93} * 70);
        const std::vector<OracleAnswer> answers = oracle.answer(instant, ids);
        for (const OracleAnswer& answer : answers) ASSERT_EQ(answer.time, (static_cast<float>(m) + 0.5f) / 5.0f);
        EXPECT_EQ(tallyOf(answers, oracle.resolveAll(instant, ids)).differentForSure, 0u);
    }
}

TEST(OracleAgreement, TheSameEveryTime) {
    const RandomFrame frame(5);
    const Oracle one(frame.plan), other(frame.plan);
    const std::vector<std::uint32_t> ids = one.tracePrimaries(frame.plan);
    EXPECT_EQ(ids, other.tracePrimaries(frame.plan));
    const std::vector<OracleAnswer> a = one.answer(frame.plan, ids), b = other.answer(frame.plan, ids);
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(a[i].lit, b[i].lit);
        ASSERT_EQ(a[i].marginal, b[i].marginal);
        ASSERT_EQ(a[i].position, b[i].position);
    }
}

TEST(OracleAgreement, NothingSeenIsNoAnswer) {
    const RandomFrame frame(5);
    const Oracle oracle(frame.plan);
    const std::vector<std::uint32_t> nothing(std::size_t{93} * 70 * 4, NO_TRIANGLE);
    for (const OracleAnswer& answer : oracle.answer(frame.plan, nothing)) ASSERT_FALSE(answer.hit || answer.tested);
    EXPECT_FALSE(oracle.resolve(frame.plan, {1, 2, 3}, NO_TRIANGLE).hit);
}

/// Share of the tested samples of `plan` whose answer changes under `changed`.
double shareThatChanges(const FramePlan& plan, const FramePlan& changed) {
    const Oracle before(plan), after(changed);
    const std::vector<std::uint32_t> ids = before.tracePrimaries(plan);
    const std::vector<OracleAnswer> a = before.answer(plan, ids), b = after.answer(changed, ids);
    std::size_t tested = 0, different = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!a[i].tested || !b[i].tested) continue;
        ++tested;
        different += a[i].lit != b[i].lit ? 1u : 0u;
    }
    EXPECT_GT(tested, 5000u);
    return static_cast<double>(different) / static_cast<double>(tested);
}

/// What a wrong oracle would overlook makes a difference: none of the agreements above is empty.
TEST(OracleAgreement, EveryMotionCounts) {
    const RandomFrame frame(9);
    EXPECT_EQ(shareThatChanges(frame.plan, frame.plan), 0.0);

    FramePlan frozenLight = frame.plan;
    frozenLight.lightClose = frozenLight.lightOpen;
    EXPECT_GT(shareThatChanges(frame.plan, frozenLight), 0.02);

    FramePlan frozenMesh = frame.plan;
    auto texels = std::make_shared<MeshTexels>(*frame.plan.texels);
    for (std::size_t i = 0; i < texels->vertices.size(); i += 2) texels->vertices[i + 1] = texels->vertices[i];
    frozenMesh.texels = texels;
    EXPECT_GT(shareThatChanges(frame.plan, frozenMesh), 0.02);

    FramePlan frozenCamera = frame.plan;
    frozenCamera.camera.close = frozenCamera.camera.open;
    EXPECT_GT(shareThatChanges(frame.plan, frozenCamera), 0.005);

    FramePlan late = frame.plan;
    late.block.timeBase = 0.02f;
    late.block.timeScale *= 0.98f;
    EXPECT_GT(shareThatChanges(frame.plan, late), 0.001);

    FramePlan otherSeed = frame.plan;
    otherSeed.block.seed += 1;
    EXPECT_GT(shareThatChanges(frame.plan, otherSeed), 0.005);
}

}  // namespace
}  // namespace timeshade
