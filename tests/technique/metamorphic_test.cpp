// Checks that need no exact value: what must not change a picture, or must change it in one direction only. The three
// scenes that come with the program, and random ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "cases/changed_scene.h"
#include "cases/procedural_scene.h"
#include "scene_catalogue.h"
#include "support/awkward_numbers.h"
#include "support/gl_environment.h"
#include "support/thorough.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

/// Quads that move and rotate over a ground, under a spot that moves; nothing repeats between seeds.
std::shared_ptr<const Scene> randomScene(std::uint32_t seed) {
    AwkwardNumbers numbers(seed);
    auto scene = std::make_shared<ProceduralScene>();
    const auto number = [&](float low, float high) { return static_cast<double>(numbers.between(low, high)); };
    const auto point = [&] {
        const double x = number(-3, 3), y = number(-3, 3);
        return glm::dvec3(x, y, number(1, 5));
    };
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 a = point(), b = a + glm::dvec3(number(-1, 1), number(-1, 1), number(-0.5f, 0.5f));
        const glm::dvec3 right(number(0.2f, 0.7f), number(-0.3f, 0.3f), number(-0.3f, 0.3f)),
            up(number(-0.3f, 0.3f), number(0.2f, 0.7f), number(-0.3f, 0.3f));
        MovingQuad quad{};
        for (int c = 0; c < 4; ++c) {
            const double s = c == 1 || c == 2 ? 1.0 : -1.0, t = c >= 2 ? 1.0 : -1.0;
            quad.open[c] = a + s * right + t * up;
            quad.close[c] = b + s * right + t * up * 0.8;
        }
        scene->quads.push_back(quad);
    }
    scene->quads.push_back(slidingQuad({0, 0, 0}, {0, 0, 0}, 6.0, -6.0, 6.0));
    scene->cameraOpen = scene->cameraClose = lookAt({2.0, -11.0, 8.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, 0.7, 0.01);
    scene->cameraClose.eye.x += 0.05;
    scene->lightOpen.position = {-0.5, 0.3, 11.0};
    scene->lightClose.position = {0.5, 0.0, 11.0};
    scene->lightOpen.outerConeAngle = scene->lightClose.outerConeAngle = 0.55;
    scene->finish();
    return scene;
}

std::shared_ptr<const Scene> sceneOf(const std::string& name) {
    static std::map<std::string, std::shared_ptr<const Scene>> known;
    std::shared_ptr<const Scene>& scene = known[name];
    if (!scene)
        scene = name.rfind("random", 0) == 0 ? randomScene(static_cast<std::uint32_t>(name.back()))
                                             : std::shared_ptr<const Scene>(openScene(name, ""));
    return scene;
}

/// With TIMESHADE_FULL_SIZE set: pictures at the program's default size. Takes minutes.
bool atFullSize() { return std::getenv("TIMESHADE_FULL_SIZE") != nullptr; }

FrameRequest requestOf(const Scene& scene) {
    FrameRequest request = atFullSize() ? FrameRequest{} : ProceduralScene::request(96, 72, 4, 256, 5);
    request.shutter = {scene.defaults().framesPerSecond, scene.defaults().shutterLength, ShutterPosition::Start};
    request.frame = scene.defaults().frame;
    return request;
}

struct Drawn {
    std::vector<std::uint32_t> ids;
    std::vector<float> lit;
    double mean() const {
        double sum = 0.0;
        for (const float value : lit) sum += static_cast<double>(value);
        return sum / static_cast<double>(lit.size());
    }
};

Drawn draw(const Scene& scene, const FrameRequest& request, Technique& technique) {
    FramePlanner planner(scene);
    technique.forget();
    sharedRenderer().draw(planner.plan(request), technique, View::Visibility);
    return {sharedRenderer().readSampleIds(), sharedRenderer().readVisibility()};
}

/// Samples that see something and whose lit differs, in a million.
double changedPpm(const Drawn& a, const Drawn& b) {
    std::size_t seen = 0, changed = 0;
    for (std::size_t i = 0; i < a.lit.size(); ++i) {
        if (a.ids[i] == NO_TRIANGLE && b.ids[i] == NO_TRIANGLE) continue;
        ++seen;
        changed += std::abs(a.lit[i] - b.lit[i]) > 0.5f ? 1u : 0u;
    }
    return seen == 0 ? 1e6 : 1e6 * static_cast<double>(changed) / static_cast<double>(seen);
}

using Parameters = std::tuple<std::string, std::string>;
class Metamorphic : public testing::TestWithParam<Parameters> {
  protected:
    Metamorphic()
        : technique_(makeTechnique(std::get<0>(GetParam()), sharedRenderer().programs())),
          scene_(sceneOf(std::get<1>(GetParam()))),
          request_(requestOf(*scene_)) {
        if (std::get<0>(GetParam()) == "accumulation") setFromText(*technique_, "renders", "8");
        // A map fitted to the picture is another map, with other texels, whenever the picture is another one.
        if (std::get<0>(GetParam()) == "history") setFromText(*technique_, "fit", "0");
        FramePlanner planner(*scene_);
        supported_ = !technique_->unsupported(planner.plan(request_));
        if (supported_) original_ = draw(*scene_, request_, *technique_);
    }
    /// Only the last render of several is compared sample by sample; its time is as good as any other.
    double ppmOf(const Scene& changed) {
        const double ppm = changedPpm(original_, draw(changed, request_, *technique_));
        if (atFullSize())
            std::printf("%s %s: %.1f ppm\n", std::get<0>(GetParam()).c_str(), std::get<1>(GetParam()).c_str(), ppm);
        return ppm;
    }

    std::unique_ptr<Technique> technique_;
    std::shared_ptr<const Scene> scene_;
    FrameRequest request_;
    Drawn original_;
    bool supported_ = false;
};

/// 27 648 samples: 100 in a million are two or three.
constexpr double allowedPpm = 110.0;

TEST_P(Metamorphic, FarScaledAndTurnedWorlds) {
    if (!supported_) GTEST_SKIP();
    EXPECT_EQ(ppmOf(ChangedScene(scene_)), 0.0) << "nothing changed";
    EXPECT_LE(ppmOf(ChangedScene(scene_, {1.0, glm::dmat3(1.0), glm::dvec3(1e4)})), allowedPpm) << "moved by 1e4";
    EXPECT_LE(ppmOf(ChangedScene(scene_, {1e-3, glm::dmat3(1.0), glm::dvec3(0.0)})), allowedPpm) << "scaled by 1e-3";
    EXPECT_LE(ppmOf(ChangedScene(scene_, {1e3, glm::dmat3(1.0), glm::dvec3(0.0)})), allowedPpm) << "scaled by 1e3";
    const double c = std::cos(0.7), s = std::sin(0.7);
    const glm::dmat3 turn =
        glm::dmat3(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0) * glm::dmat3(1.0, 0.0, 0.0, 0.0, c, s, 0.0, -s, c);
    EXPECT_LE(ppmOf(ChangedScene(scene_, {1.0, turn, glm::dvec3(0.0)})), 3.0 * allowedPpm) << "turned";
}

TEST_P(Metamorphic, TheSameSurfaceOtherwiseCut) {
    if (!supported_) GTEST_SKIP();
    EXPECT_LE(ppmOf(ChangedScene(scene_, {}, withCornersTurned)), allowedPpm) << "corners turned";
    // What a technique computes triangle by triangle may depend on how the surface is cut: within the bound it states.
    const double allowed = std::max(3.0 * allowedPpm, 1e6 * technique_->samplingTraits().triangulationError);
    EXPECT_LE(ppmOf(ChangedScene(scene_, {}, subdivided)), allowed) << "each triangle in four";
    EXPECT_LE(ppmOf(ChangedScene(scene_, {}, withDiagonalsTurned)), allowed) << "quads cut along the other diagonal";
}

TEST(OtherDiagonal, IsTurnedInEveryQuadOnce) {
    const std::shared_ptr<const Scene> scene = sceneOf("random1");
    const MotionMesh mesh = scene->motionMesh(0.0, 1.0), turned = withDiagonalsTurned(mesh);
    ASSERT_EQ(turned.topology->triangles.size(), mesh.topology->triangles.size());
    for (std::size_t i = 0; i < turned.topology->triangles.size(); ++i)
        EXPECT_NE(turned.topology->triangles[i], mesh.topology->triangles[i]);
    EXPECT_NE(withDiagonalsTurned(sceneOf("pillars")->motionMesh(0.0, 0.02)).topology->triangles,
              sceneOf("pillars")->motionMesh(0.0, 0.02).topology->triangles);
}

TEST_P(Metamorphic, TimeBackwardsAndInHalves) {
    if (!supported_) GTEST_SKIP();
    // Other samples of the same mean: four standard errors, the samples of a pixel being independent of all others.
    const double noise = 4.0 * 0.5 / std::sqrt(static_cast<double>(original_.lit.size())) + 0.002;
    const double open = request_.shutter.openSeconds(request_.frame),
                 close = request_.shutter.closeSeconds(request_.frame);
    ChangedScene backwards(scene_);
    backwards.reverse(open, close);
    if (technique_->renders() == 1) {
        EXPECT_NEAR(draw(backwards, request_, *technique_).mean(), original_.mean(), noise);
    }
    const SamplingTraits traits = technique_->samplingTraits();
    if (traits.times == SamplingTraits::Times::OneInstant || technique_->renders() > 1) return;
    // Whose casters are looked at throughout the shutter, whenever the receiver is seen, has an error that depends on
    // how long that is.
    if (statementOf(*technique_).ignoresReceiverTime()) return;
    FrameRequest half = request_;
    half.shutter.length *= 0.5;
    half.samplesPerPixel /= 2;  // strata as long as before, and with them whatever a technique's error depends on
    const double first = draw(*scene_, half, *technique_).mean();
    half.frame += half.shutter.length;
    const double second = draw(*scene_, half, *technique_).mean();
    EXPECT_NEAR(0.5 * (first + second), original_.mean(), 1.5 * noise) << "halves of the shutter";
}

TEST_P(Metamorphic, ACasterMoreNeverBrightens) {
    if (!supported_) GTEST_SKIP();
    // A quad between the light and the centre of the scene, which touches nothing.
    const LightPose light = scene_->light(request_.shutter.openSeconds(request_.frame));
    const Bounds& bounds = scene_->bounds();
    const glm::dvec3 towards =
        light.kind == LightKind::Directional ? light.axes[2] * bounds.diagonal() : light.position - bounds.centre();
    const glm::dvec3 middle = bounds.centre() + 0.25 * towards, x = 0.05 * bounds.diagonal() * light.axes[0],
                     y = 0.05 * bounds.diagonal() * light.axes[1];
    const glm::dvec3 corners[4] = {middle - x - y, middle + x - y, middle + x + y, middle - x + y};
    const Drawn with =
        draw(ChangedScene(scene_, {}, [&](MotionMesh mesh) { return withQuad(std::move(mesh), corners); }), request_,
             *technique_);
    // Either value may be off by what the technique states.
    const float own = 1e-3f + 2.0f * static_cast<float>(technique_->samplingTraits().statedError);
    std::size_t brighter = 0, darker = 0;
    for (std::size_t i = 0; i < with.lit.size(); ++i) {
        if (with.ids[i] != original_.ids[i]) continue;
        brighter += with.lit[i] > original_.lit[i] + own ? 1u : 0u;
        darker += with.lit[i] < original_.lit[i] - 1e-3f ? 1u : 0u;
    }
    // A history holds one value for the whole pixel: where the new caster is seen, the pixel's other samples share its
    // light. Layers are parted and moved by means over all casters of a tile, which one more changes.
    const std::string name = std::get<0>(GetParam());
    const bool byMeans = light.kind == LightKind::Directional || name == "layers";
    const double allowed = byMeans ? 1e4 : name == "history" ? 1e3 : 0.0;
    EXPECT_LE(1e6 * static_cast<double>(brighter) / static_cast<double>(with.lit.size()), allowed);
    EXPECT_GT(darker, 0u) << "the caster casts no shadow, so the test shows nothing";
}

std::vector<std::string> techniqueNames() {
    std::vector<std::string> names;
    for (const TechniqueDescription& description : techniqueDescriptions()) names.push_back(description.name);
    return names;
}

/// All techniques in all scenes; as a rule every seventh of them, so that each has one scene or none.
std::vector<Parameters> techniquesInScenes() {
    std::vector<Parameters> all;
    std::size_t number = 0;
    for (const std::string& technique : techniqueNames())
        for (const char* scene : {"chess", "octopus", "pillars", "random1", "random2"})
            if (isDrawn(number++, 7)) all.emplace_back(technique, scene);
    return all;
}

INSTANTIATE_TEST_SUITE_P(AllTechniques, Metamorphic, testing::ValuesIn(techniquesInScenes()),
                         [](const testing::TestParamInfo<Parameters>& test) {
                             return std::get<0>(test.param) + "_" + std::get<1>(test.param);
                         });

}  // namespace
}  // namespace timeshade
