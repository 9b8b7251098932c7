// A sun or a spot that turns inside the shutter, against the mean of many instants: each a frame of its own, whose
// shutter is closed and whose light comes from the scene at that time. The frame under test knows both ends alone.
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cases/procedural_scene.h"
#include "core/error.h"
#include "measure/reference_technique.h"
#include "measure/verification.h"
#include "support/gl_environment.h"
#include "support/thorough.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

constexpr int width = 48, height = 36;
constexpr int samplesAnInstant = 4;

/// Turns about an axis through the light by an angle in a second.
glm::dmat3 turnedBy(const glm::dmat3& axes, const glm::dvec3& about, double angle) {
    const glm::dvec3 k = glm::normalize(about);
    glm::dmat3 turned;
    for (int i = 0; i < 3; ++i)
        turned[i] = axes[i] * std::cos(angle) + glm::cross(k, axes[i]) * std::sin(angle) +
                    k * glm::dot(k, axes[i]) * (1.0 - std::cos(angle));
    return turned;
}

/// Posts and a board over a ground, as they are or in motion; all else is the procedural scene's.
class TurningLight : public Scene {
  public:
    TurningLight(LightKind kind, glm::dvec3 about, double degrees, bool castersMove, double speed = 1.0)
        : about_(about), degrees_(degrees) {
        const glm::dvec3 move = castersMove ? glm::dvec3(0.7, -0.5, 0.4 * speed) : glm::dvec3(0.0);
        scene_.quads.push_back(slidingQuad({0, 0, 0}, {0, 0, 0}, 7.0, -7.0, 7.0));
        scene_.quads.push_back(
            slidingQuad(glm::dvec3(0.3, 0.2, 1.6), glm::dvec3(0.3, 0.2, 1.6) + move, 0.8, -0.5, 0.5));
        scene_.quads.push_back(
            slidingQuad(glm::dvec3(-1.6, 0.9, 0.8), glm::dvec3(-1.6, 0.9, 0.8) - move, 0.4, -1.0, 0.4));
        scene_.quads.push_back(slidingQuad({1.6, -1.0, 2.5}, {1.6, -1.0, 2.5}, 0.3, -0.9, 0.9));
        scene_.cameraOpen = scene_.cameraClose = lookAt({1.0, -7.0, 8.0}, {0.0, 0.0, 0.5}, {0.0, 0.0, 1.0}, 0.7, 0.01);
        light_.kind = kind;
        light_.position = {0.3, 0.1, 7.0};
        light_.outerConeAngle = 0.55;
        light_.innerConeAngle = 0.3;
        scene_.finish();
    }

    const std::string& name() const override { return scene_.name(); }
    double duration() const override { return scene_.duration(); }
    const SceneDefaults& defaults() const override { return scene_.defaults(); }
    const std::vector<Material>& materials() const override { return scene_.materials(); }
    const std::vector<Image>& images() const override { return scene_.images(); }
    const std::vector<CameraBookmark>& cameras() const override { return scene_.cameras(); }
    CameraPose camera(std::size_t index, double seconds) const override { return scene_.camera(index, seconds); }
    LightPose light(double seconds) const override {
        LightPose pose = light_;
        pose.axes = turnedBy(light_.axes, about_, glm::radians(degrees_) * (seconds - 0.5));
        return pose;
    }
    MotionMesh motionMesh(double open, double close) const override { return scene_.motionMesh(open, close); }
    const Bounds& bounds() const override { return scene_.bounds(); }
    const std::vector<std::string>& notes() const override { return scene_.notes(); }

  private:
    ProceduralScene scene_;
    LightPose light_;
    glm::dvec3 about_;
    double degrees_;
};

/// Mean light of each pixel over all strata, 0 where nothing was tested as well as where nothing is lit.
class Means {
  public:
    /// A picture of visibility, which is the mean over its samples and renders.
    void add(const LinearImage& picture) {
        sum_.resize(std::size_t(width) * height);
        for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += static_cast<double>(picture.rgb[3 * i]);
        ++pictures_;
    }
    double of(std::size_t pixel) const { return sum_[pixel] / pictures_; }

  private:
    std::vector<double> sum_;
    int pictures_ = 0;
};

FrameRequest requestOf(int samples, int map, std::uint32_t seed) {
    return ProceduralScene::request(width, height, samples, map, seed);
}

Means composed(const Scene& scene, int instants) {
    FrameRenderer& renderer = sharedRenderer();
    ReferenceTechnique truth;
    FramePlanner planner(scene);
    Means means;
    for (int k = 0; k < instants; ++k) {
        FrameRequest request = requestOf(samplesAnInstant, 256, 1000u + static_cast<std::uint32_t>(k));
        request.shutter.length = 0.0;
        request.frame = (k + 0.5) / instants;
        renderer.draw(planner.plan(request), truth, View::Visibility);
        means.add(renderer.readRadiance());
    }
    return means;
}

double rmsOf(const Means& a, const Means& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < std::size_t(width) * height; ++i) sum += (a.of(i) - b.of(i)) * (a.of(i) - b.of(i));
    return std::sqrt(sum / (width * height));
}

Means drawn(const Scene& scene, const std::string& technique, int frames) {
    FrameRenderer& renderer = sharedRenderer();
    const std::unique_ptr<Technique> made = makeTechnique(technique, renderer.programs());
    FramePlanner planner(scene);
    Means means;
    for (int k = 0; k < frames; ++k) {
        const FrameRequest request = requestOf(32, usualOrAll(512, 1024), 50u + static_cast<std::uint32_t>(k));
        renderer.draw(planner.plan(request), *made, View::Visibility);
        means.add(renderer.readRadiance());
    }
    return means;
}

struct Setting {
    std::string name;
    LightKind kind;
    glm::dvec3 about;
    double degrees;
    bool castersMove;
    double speed = 1.0;  ///< of casters, upwards
};

void PrintTo(const Setting& setting, std::ostream* out) { *out << setting.name; }

class LightTurns : public testing::TestWithParam<Setting> {
  protected:
    TurningLight scene() const {
        return {GetParam().kind, GetParam().about, GetParam().degrees, GetParam().castersMove, GetParam().speed};
    }
};

TEST_P(LightTurns, IsTheMeanOfItsInstants) {
    const TurningLight turning = scene();
    const Means truth = composed(turning, 256);
    const TurningLight still(GetParam().kind, GetParam().about, 0.0, GetParam().castersMove, GetParam().speed);
    const double without = rmsOf(drawn(still, "exact", 2), truth);
    // As a rule every third technique beside `exact`, others with other lights.
    std::size_t number = GetParam().name.size();
    for (const TechniqueDescription& technique : techniqueDescriptions()) {
        const TechniqueStatement stated = statementOf(*makeTechnique(technique.name, sharedRenderer().programs()));
        if (stated.isOfOneInstant()) continue;
        if (!isDrawn(number++, 6) && technique.name != "exact") continue;
        // The ground moves in the frame of a light that turns.
        if (GetParam().castersMove && stated.ignoresReceiverTime()) continue;
        // Maps over time take bent paths as straight, and the plan says so.
        if (GetParam().speed > 1.0 && technique.name != "exact") continue;
        const double error = rmsOf(drawn(turning, technique.name, usualOrAll(2, 3)), truth);
        RecordProperty(technique.name, std::to_string(error));
        EXPECT_LT(error, technique.name == "exact" ? 0.022 : 0.035)
            << technique.name << "; without the turn " << without;
        EXPECT_LT(error, 0.5 * without) << technique.name;
    }
}

TEST_P(LightTurns, ExactAgreesWithTheOracle) {
    const TurningLight turning = scene();
    FrameRenderer& renderer = sharedRenderer();
    const std::unique_ptr<Technique> exact = makeTechnique("exact", renderer.programs());
    // One interval and many cells: where a path bends most, compared to what a list is for.
    setFromText(*exact, "buckets", "1");
    setFromText(*exact, "side", "256");
    FramePlanner planner(turning);
    std::size_t tested = 0, wrong = 0;
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        VerificationOptions how;
        how.checkPrimaries = false;
        const Verification v = verifyFrame(renderer, planner.plan(requestOf(16, 128, seed)), *exact, how);
        tested += v.tested;
        wrong += v.falseShadow + v.falseLit;
    }
    EXPECT_GT(tested, 50000u);
    EXPECT_LE(wrong, 2u);
}

INSTANTIATE_TEST_SUITE_P(
    Lights, LightTurns,
    testing::Values(Setting{"sun", LightKind::Directional, {0.3, 1.0, 0.0}, 24.0, false},
                    Setting{"sun_aslant", LightKind::Directional, {1.0, -0.4, 0.9}, 30.0, false},
                    Setting{"sun_over_fast_casters", LightKind::Directional, {0.8, 0.6, 0.1}, 60.0, true, 6.0},
                    Setting{"sun_over_moving_casters", LightKind::Directional, {0.8, 0.6, 0.1}, 20.0, true},
                    Setting{"spot", LightKind::Spot, {0.2, 1.0, 0.0}, 30.0, false},
                    Setting{"spot_over_moving_casters", LightKind::Spot, {1.0, 0.3, 0.2}, 20.0, true}),
    [](const auto& tested) { return tested.param.name; });

TEST(LightTurnsLimits, AreSaidInOneLine) {
    const TurningLight sun(LightKind::Directional, {1.0, 0.0, 0.0}, 100.0, false);
    EXPECT_THROW(FramePlanner(sun).plan(requestOf(1, 64, 1)), Error);
    const TurningLight spot(LightKind::Spot, {1.0, 0.0, 0.0}, 80.0, false);
    EXPECT_NO_THROW(FramePlanner(spot).plan(requestOf(1, 64, 1)));
}

TEST(LightTurnsLimits, TheMapsBentPathsAreSaid) {
    const TurningLight bent(LightKind::Directional, {0.8, 0.6, 0.0}, 40.0, true);
    const FramePlan plan = FramePlanner(bent).plan(requestOf(1, 1024, 1));
    EXPECT_NEAR(plan.motion.lightTurnDegrees, 40.0, 1e-6);
    ASSERT_FALSE(plan.warnings.empty());
    EXPECT_NE(plan.warnings.back().find("while the sun turns"), std::string::npos);
    const TurningLight straight(LightKind::Directional, {0.8, 0.6, 0.0}, 40.0, false);
    for (const std::string& warning : FramePlanner(straight).plan(requestOf(1, 1024, 1)).warnings)
        EXPECT_EQ(warning.find("while the sun turns"), std::string::npos);
}

}  // namespace
}  // namespace timeshade
