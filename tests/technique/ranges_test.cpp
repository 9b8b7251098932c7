// Depth-time ranges on scenes whose lit share is known exactly, in the repaired form and as published: exact to the
// texel where prisms can be, and wrong by as much as theory says where they must be.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "cases/closed_form_cases.h"
#include "core/error.h"
#include "support/gl_environment.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

constexpr int side = 16, strata = 32;
using Points = std::array<glm::dvec3, 3>;

LightPose spot(const glm::dvec3& position) {
    LightPose light;
    light.position = position;  // axes: identity, so that it shines along -z
    light.outerConeAngle = 0.62;
    light.innerConeAngle = 0.55;
    light.intensity = glm::dvec3(100.0);
    return light;
}

/// A triangle as a quad whose last two corners coincide.
MovingQuad movingTriangle(const Points& open, const Points& close) {
    MovingQuad quad{};
    for (std::size_t i = 0; i < 4; ++i) {
        quad.open[i] = open[std::min<std::size_t>(i, 2)];
        quad.close[i] = close[std::min<std::size_t>(i, 2)];
    }
    return quad;
}

MovingQuad box(double x0, double x1, double y0, double y1, double z) {
    MovingQuad quad{};
    const glm::dvec3 corners[4] = {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
    for (int i = 0; i < 4; ++i) quad.open[i] = quad.close[i] = corners[i];
    return quad;
}

/// Casters over a receiver so small that all of it has one lit value, seen from `height` above.
std::shared_ptr<ProceduralScene> over(const glm::dvec3& receiver, std::vector<MovingQuad> casters,
                                      double height = 1.0) {
    auto scene = std::make_shared<ProceduralScene>();
    scene->quads = std::move(casters);
    scene->quads.push_back(slidingQuad(receiver, receiver, 0.002, -0.002, 0.002));
    scene->cameraOpen.eye = receiver + glm::dvec3(0.0, 0.0, height);
    scene->cameraOpen.verticalFieldOfView = 2.0 * std::atan(0.001 / height);
    scene->cameraOpen.nearDistance = 0.001;
    scene->cameraClose = scene->cameraOpen;
    scene->lightOpen = scene->lightClose = spot({0.0, 0.0, 10.0});
    scene->finish();
    return scene;
}

/// The quad Q(c) of the analytic cases at height z, its centre going from c0 to c1.
MovingQuad caster(double c0, double c1, double z = 5.0) {
    return slidingQuad({c0, 0.0, z}, {c1, 0.0, z}, 0.5, -0.4, 0.6);
}

MovingQuad inPlane(const std::array<glm::dvec2, 3>& open, const std::array<glm::dvec2, 3>& close) {
    Points a, b;
    for (std::size_t i = 0; i < 3; ++i) {
        a[i] = glm::dvec3(open[i], 5.0);
        b[i] = glm::dvec3(close[i], 5.0);
    }
    return movingTriangle(a, b);
}

std::shared_ptr<ProceduralScene> flipTriangle() {
    return over({0.0, 0.2, 0.0}, {inPlane({{{-1, -1}, {1, -1}, {0, 1}}}, {{{-1, 1.5}, {1, 1.5}, {0, -2}}})});
}

std::shared_ptr<ProceduralScene> invertTriangle() {
    const double h = 0.5 * std::sqrt(3.0);
    return over({0.4, 0.2, 0.0}, {inPlane({{{1, 0}, {-0.5, h}, {-0.5, -h}}}, {{{-1, 0}, {0.5, -h}, {0.5, h}}})});
}

std::shared_ptr<ProceduralScene> vertexPath() {
    return over({1.4, -1.4, 0.0}, {inPlane({{{-0.1, -0.1}, {0.1, -0.1}, {0, 0.1}}}, {{{-2, -2}, {2, -2}, {0, 2}}})});
}

std::shared_ptr<ProceduralScene> edgeOn() {
    return over({0, 0, 0},
                {movingTriangle({{{-1, 0, 4}, {0, 0, 6}, {1, 0, 4}}}, {{{-1, 0, 5}, {0, 0, 7}, {1, 0, 5}}})});
}

std::shared_ptr<ProceduralScene> pastTheLight() {
    return over({0, 0, 0}, {slidingQuad({0, 0, 9.5}, {0, 0, 11}, 0.5, -0.4, 0.6)});
}

std::shared_ptr<ProceduralScene> lightRecedes() {
    auto scene = over({2, 0, 0}, {box(0.5, 1.25, -0.5, 0.5, 5.0)});
    scene->lightClose = spot({0, 0, 20});
    return scene;
}

/// The caster goes from distance 2 to 20; the receiver is 11 away.
std::shared_ptr<ProceduralScene> rangeLerp() {
    return over({0.01, 0.02, -1.0}, {slidingQuad({0, 0, 8}, {0, 0, -10}, 1.0, -1.0, 1.0)}, 0.01);
}

/// Caster i of `count` is over the receiver during [i, i + 1/2] / count.
std::shared_ptr<ProceduralScene> slivers(int count) {
    std::vector<MovingQuad> casters;
    const double speed = 20.0;
    for (int i = 0; i < count; ++i) {
        const double middle = (i + 0.25) / count;
        casters.push_back(
            slidingQuad({-speed * middle, 0, 5}, {speed * (1.0 - middle), 0, 5}, 0.25 * speed / count, -0.05, 0.05));
    }
    return over({0.001, 0.002, 0.0}, std::move(casters));
}

double litShare(Scene& scene, bool asPublished, int mapSize = 1024, int width = side, int height = side) {
    const std::unique_ptr<Technique> technique = makeTechnique("ranges", sharedRenderer().programs());
    setFromText(*technique, "as_published", asPublished ? "on" : "off");
    sharedRenderer().draw(FramePlanner(scene).plan(ProceduralScene::request(width, height, strata, mapSize, 11)),
                          *technique, View::Visibility);
    double sum = 0.0;
    const LinearImage image = sharedRenderer().readRadiance();
    for (const float value : image.rgb) sum += static_cast<double>(value);
    return sum / static_cast<double>(image.rgb.size());
}

/// Each end of a shadow splits one stratum of each pixel.
constexpr double noise = 4.0 * 0.5 / (strata * side);

double figure(const Technique& technique, const std::string& name) {
    for (const TechniqueStatistic& f : technique.statistics())
        if (f.name == name) return f.value;
    throw std::logic_error("no figure " + name);
}

TEST(Ranges, AreExactWherePrismsCanBe) {
    for (const bool asPublished : {false, true}) {
        SCOPED_TRACE(asPublished ? "as published" : "repaired");
        // A texel at z = 5 is 0.007 wide; speeds are 2.5 and more.
        const double tolerance = 2.0 * noise + 0.003;
        for (const char* name : {"quad_sweeps_point", "quad_enters", "light_slides", "receiver_slides",
                                 "light_and_receiver_slide", "triplicate"})
            EXPECT_NEAR(litShare(*closedFormCase(name).scene, asPublished, 1024, 4, 128), closedFormCase(name).exact,
                        tolerance)
                << name;
        EXPECT_NEAR(litShare(*over({0, 0, 0}, {caster(-1, 4), caster(-3.5, 1.5)}), asPublished), 0.6, 2.0 * tolerance)
            << "two_disjoint";
        EXPECT_NEAR(litShare(*over({0, 0, 0}, {caster(-1, 4), caster(-1.5, 3.5, 6)}), asPublished), 0.7, tolerance)
            << "two_overlap";
        EXPECT_EQ(litShare(*edgeOn(), asPublished), 1.0) << "edge_on";
        EXPECT_NEAR(litShare(*over({0, 0, 0}, {caster(-1.25, 1.25), caster(1.25, -1.25)}), asPublished), 0.6, tolerance)
            << "opposite_motion";
        EXPECT_NEAR(litShare(*slivers(100), asPublished, 256), 0.5, 0.02) << "slivers";
    }
    EXPECT_NEAR(litShare(*slivers(1000), false, 256), 0.5, 0.02) << "many_slivers";
}

/// Where a triangle does not only translate, the sides of its prism are four flat triangles instead of a bilinear
/// surface.
TEST(Ranges, RepairedIsRightWithinTheBilinearError) {
    EXPECT_NEAR(litShare(*flipTriangle(), false), 0.14, 0.02);
    EXPECT_NEAR(litShare(*invertTriangle(), false), 0.3 + 0.05 * std::sqrt(3.0), 0.02);
    EXPECT_NEAR(litShare(*vertexPath(), false), 6.0 / 19.0, 0.02);
}

TEST(Ranges, RepairedIsRightWhereThePublishedFormFails) {
    EXPECT_NEAR(litShare(*rangeLerp(), false), 0.5, 2.0 * noise + 0.001);
    EXPECT_NEAR(litShare(*pastTheLight(), false), 2.0 / 3.0, 2.0 * noise);
}

/// Vertices in view space and times that are interpolated with perspective: a light that recedes is no difficulty.
TEST(Ranges, BothFormsFollowALightThatRecedes) {
    for (const bool asPublished : {false, true})
        EXPECT_NEAR(litShare(*lightRecedes(), asPublished), 2.0 / 3.0, 2.0 * noise + 0.004) << asPublished;
}

TEST(Ranges, PublishedFailsAsPredicted) {
    EXPECT_NEAR(litShare(*flipTriangle(), true), 0.0, 0.01) << "the gap between the two coverage intervals is lost";
    EXPECT_NEAR(litShare(*invertTriangle(), true), 0.0, 0.01) << "caps are paired with caps: covered throughout";
    // 1/d goes linearly from 1/2 to 1/20, and is 1/11 at u = 10/11.
    EXPECT_NEAR(litShare(*rangeLerp(), true), 1.0 / 11.0, 2.0 * noise + 0.001) << "NDC depth linear in time";
}

/// The near plane cuts prisms open, which the statistics count; the repaired form makes no prisms of triangles that
/// cross it.
TEST(Ranges, CountWhatIsNotClosed) {
    const auto scene = pastTheLight();
    for (const bool asPublished : {false, true}) {
        const std::unique_ptr<Technique> technique = makeTechnique("ranges", sharedRenderer().programs());
        setFromText(*technique, "as_published", asPublished ? "on" : "off");
        sharedRenderer().draw(FramePlanner(*scene).plan(ProceduralScene::request(4, 4, 2, 256, 1)), *technique,
                              View::Visibility);
        EXPECT_EQ(figure(*technique, "near-plane triangles"), asPublished ? 0.0 : 2.0);
        EXPECT_EQ(figure(*technique, "lists with unpaired fragments") > 0.0, asPublished);
    }
}

/// Neighbours of a receiver on a moving cube do not shadow it, nor do the cube's other sides.
TEST(Ranges, ACubeTopIsLit) {
    auto scene = std::make_shared<ProceduralScene>();
    const glm::dvec3 corner[8] = {{-.5, -.5, -.5}, {.5, -.5, -.5}, {.5, .5, -.5}, {-.5, .5, -.5},
                                  {-.5, -.5, .5},  {.5, -.5, .5},  {.5, .5, .5},  {-.5, .5, .5}};
    const int faces[6][4] = {{4, 5, 6, 7}, {3, 2, 1, 0}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    for (const auto& face : faces) {
        MovingQuad quad{};
        for (int i = 0; i < 4; ++i) {
            quad.open[i] = corner[face[i]];
            quad.close[i] = corner[face[i]] + glm::dvec3(1, 0, 0);
        }
        scene->quads.push_back(quad);
    }
    scene->cameraOpen.eye = {0.0, 0.0, 1.5};
    scene->cameraClose.eye = {1.0, 0.0, 1.5};
    scene->cameraOpen.verticalFieldOfView = scene->cameraClose.verticalFieldOfView = 2.0 * std::atan(0.45);
    scene->lightOpen = scene->lightClose = spot({0.0, 0.0, 10.0});
    scene->finish();
    EXPECT_EQ(litShare(*scene, false), 1.0);
}

/// A steep moving triangle, without any bias: its own ranges are recognised by its number and skipped.
TEST(Ranges, NoTriangleShadowsItself) {
    for (const bool asPublished : {false, true}) {
        auto scene = std::make_shared<ProceduralScene>();
        const glm::dvec3 move(1.0, 0.0, 0.5);
        const Points open{{{-1, -1, 0}, {1, -1, 0.8}, {0, 1, 0.4}}};
        scene->quads.push_back(movingTriangle(open, {{open[0] + move, open[1] + move, open[2] + move}}));
        scene->cameraOpen.eye = {0.0, -0.3, 2.0};
        scene->cameraClose.eye = scene->cameraOpen.eye + move;
        scene->cameraOpen.verticalFieldOfView = scene->cameraClose.verticalFieldOfView = 0.2;
        scene->lightOpen = scene->lightClose = spot({0.0, 0.0, 10.0});
        scene->finish();
        const std::unique_ptr<Technique> technique = makeTechnique("ranges", sharedRenderer().programs());
        for (const auto& [key, value] :
             {std::pair{"as_published", asPublished ? "on" : "off"}, {"bias", "0"}, {"slope_bias", "0"}})
            setFromText(*technique, key, value);
        sharedRenderer().draw(FramePlanner(*scene).plan(ProceduralScene::request(side, side, 4, 128, 1)), *technique,
                              View::Visibility);
        for (const float lit : sharedRenderer().readVisibility()) ASSERT_EQ(lit, 1.0f);
    }
}

/// The values of one of the technique's own views.
std::vector<float> drawnView(const FramePlan& plan, Technique& technique, const std::string& name) {
    sharedRenderer().draw(plan, technique, View::Final, name);
    return sharedRenderer().readRadiance().rgb;
}

/// Three quads of two triangles each are over the receiver from u = 0.3 on.
TEST(Ranges, ViewsShowTheTexelsOfTheReceivers) {
    for (const bool asPublished : {false, true}) {
        const auto scene = over({0.0, 0.03, 0.0}, {caster(-1.25, 1.25), caster(-1.25, 1.25), caster(-1.25, 1.25)});
        const std::unique_ptr<Technique> technique = makeTechnique("ranges", sharedRenderer().programs());
        setFromText(*technique, "as_published", asPublished ? "on" : "off");
        const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(8, 8, 4, 1024, 1));
        for (const float ranges : drawnView(plan, *technique, "ranges")) EXPECT_EQ(ranges, 6.0f);
        for (const float time : drawnView(plan, *technique, "time")) EXPECT_NEAR(time, 0.3f, 0.005f);
        EXPECT_EQ(figure(*technique, asPublished ? "triangles with a prism" : "dynamic triangles"),
                  asPublished ? 8.0 : 6.0);
        EXPECT_EQ(figure(*technique, "static triangles"), asPublished ? 0.0 : 2.0);
        // From the light: the map fills the square picture, and most of it is empty.
        const std::vector<float> seen = drawnView(plan, *technique, "light");
        EXPECT_GE(*std::min_element(seen.begin(), seen.end()), 0.0f);
        EXPECT_EQ(*std::max_element(seen.begin(), seen.end()), 6.0f);
        EXPECT_GT(std::count(seen.begin(), seen.end(), 0.0f), 20);
        EXPECT_EQ(figure(*technique, "lists with unpaired fragments"), 0.0);
    }
    const auto still = over({0, 0, 0}, {caster(0, 0)});
    const std::unique_ptr<Technique> technique = makeTechnique("ranges", sharedRenderer().programs());
    const FramePlan plan = FramePlanner(*still).plan(ProceduralScene::request(8, 8, 4, 256, 1));
    for (const float ranges : drawnView(plan, *technique, "ranges")) EXPECT_EQ(ranges, 0.0f);
    for (const float time : drawnView(plan, *technique, "time")) EXPECT_LT(time, 0.0f) << "nothing to show";
    EXPECT_EQ(figure(*technique, "fragments"), 0.0) << "static triangles have no prisms";
    EXPECT_EQ(figure(*technique, "static triangles"), 4.0);
    EXPECT_EQ(litShare(*still, false), 0.0);
}

/// A map whose lists can't be held is refused with the limit's name, and the next frame is drawn as usual.
TEST(Ranges, NameTheLimitThatAMapMeets) {
    const auto scene = over({0, 0, 0}, {caster(-1.25, 1.25)});
    const std::unique_ptr<Technique> technique = makeTechnique("ranges", sharedRenderer().programs());
    FramePlanner planner(*scene);
    GLint64 largest = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest);
    if (largest >= 4 * 8192ll * 8192) GTEST_SKIP() << "this device takes the largest map";
    try {
        sharedRenderer().draw(planner.plan(ProceduralScene::request(side, side, 2, 8192, 1)), *technique,
                              View::Visibility);
        FAIL() << "was drawn";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("GL_MAX_SHADER_STORAGE_BLOCK_SIZE"), std::string::npos)
            << error.what();
        EXPECT_NE(std::string(error.what()).find("--map"), std::string::npos) << error.what();
    }
    sharedRenderer().draw(planner.plan(ProceduralScene::request(side, side, 2, 256, 1)), *technique, View::Visibility);
    const std::vector<float> lit = sharedRenderer().readVisibility();
    EXPECT_NEAR(std::accumulate(lit.begin(), lit.end(), 0.0) / static_cast<double>(lit.size()), 0.6, 0.1);
}

}  // namespace

}  // namespace timeshade
