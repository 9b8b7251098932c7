// Temporal shadow maps on scenes whose lit share is known exactly: the repaired form is right to the texel, also where
// triangles rotate; the published form is wrong by as much as theory says. What the coverage map may and may not
// change, and how much memory the lists take.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "cases/closed_form_cases.h"
#include "shared/hash.shared.h"
#include "support/gl_environment.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

constexpr int side = 16, strata = 32;
/// Each end of a shadow splits one stratum of each pixel.
constexpr double noise = 4.0 * 0.5 / (strata * side);

using Corners = std::array<glm::dvec3, 3>;

MovingQuad triangle(const Corners& open, const Corners& close) {
    MovingQuad quad{};  // its last two corners coincide
    for (std::size_t i = 0; i < 4; ++i) {
        quad.open[i] = open[std::min<std::size_t>(i, 2)];
        quad.close[i] = close[std::min<std::size_t>(i, 2)];
    }
    return quad;
}

MovingQuad caster(double c0, double c1, double z = 5.0) {
    return slidingQuad({c0, 0.0, z}, {c1, 0.0, z}, 0.5, -0.4, 0.6);
}

/// Casters over a receiver so small that all of it has one lit value.
std::shared_ptr<ProceduralScene> over(const glm::dvec3& receiver, std::vector<MovingQuad> casters,
                                      double cameraHeight = 1.0) {
    auto scene = std::make_shared<ProceduralScene>();
    scene->quads = std::move(casters);
    scene->quads.push_back(slidingQuad(receiver, receiver, 0.002, -0.002, 0.002));
    scene->cameraOpen.eye = receiver + glm::dvec3(0.0, 0.0, cameraHeight);
    scene->cameraOpen.verticalFieldOfView = 2.0 * std::atan(0.001 / cameraHeight);
    scene->cameraOpen.nearDistance = 0.001;
    scene->cameraClose = scene->cameraOpen;
    scene->lightOpen.position = {0.0, 0.0, 10.0};
    scene->lightOpen.outerConeAngle = 0.62;
    scene->lightOpen.innerConeAngle = 0.55;
    scene->lightOpen.intensity = glm::dvec3(100.0);
    scene->lightClose = scene->lightOpen;
    scene->finish();
    return scene;
}

std::shared_ptr<ProceduralScene> flipTriangle() {
    return over({0.0, 0.2, 0.0},
                {triangle({{{-1, -1, 5}, {1, -1, 5}, {0, 1, 5}}}, {{{-1, 1.5, 5}, {1, 1.5, 5}, {0, -2, 5}}})});
}

std::shared_ptr<ProceduralScene> invertTriangle() {
    const double h = 0.5 * std::sqrt(3.0);
    return over({0.4, 0.2, 0.0},
                {triangle({{{1, 0, 5}, {-0.5, h, 5}, {-0.5, -h, 5}}}, {{{-1, 0, 5}, {0.5, -h, 5}, {0.5, h, 5}}})});
}
const double invertLit = 0.3 + 0.05 * std::sqrt(3.0);

std::shared_ptr<ProceduralScene> lightRecedes() {
    auto scene = over({2, 0, 0}, {slidingQuad({0.875, 0, 5}, {0.875, 0, 5}, 0.375, -0.5, 0.5)});
    scene->lightClose.position.z = 20.0;
    return scene;
}

/// The caster goes from distance 2 to 20; the receiver is 11 away.
std::shared_ptr<ProceduralScene> rangeLerp() {
    return over({0.01, 0.02, -1.0}, {slidingQuad({0, 0, 8}, {0, 0, -10}, 1.0, -1.0, 1.0)}, 0.01);
}

/// Boards that translate, rotate and deform above one another, some over the same texels throughout, above a floor that
/// rises a little.
std::shared_ptr<ProceduralScene> heap(std::uint32_t seed) {
    std::uint32_t state = seed;
    const auto number = [&](double low, double high) {
        state = shared::hashWord(state + 0x9e3779b9u);
        return low + (high - low) * static_cast<double>(state) / 4294967296.0;
    };
    auto scene = over({0, 0, 0}, {});
    scene->quads.clear();
    for (int i = 0; i < 40; ++i) {
        const glm::dvec3 centre(number(-2, 2), number(-2, 2), number(1, 7)),
            way(number(-0.5, 0.5), number(-0.5, 0.5), number(-0.5, 0.5));
        const double width = number(0.3, 1.5), height = number(0.3, 1.5);
        MovingQuad quad = slidingQuad(centre, centre + way, width, -height, height);
        if (i % 2 == 1)
            for (glm::dvec3& corner : quad.close)
                corner += glm::dvec3(number(-0.4, 0.4), number(-0.4, 0.4), number(-0.4, 0.4));
        scene->quads.push_back(quad);
    }
    scene->quads.push_back(slidingQuad({0, 0, 0}, {0, 0, 0.2}, 5.0, -5.0, 5.0));
    scene->cameraOpen.eye = scene->cameraClose.eye = {0.0, 0.0, 12.0};
    scene->cameraOpen.verticalFieldOfView = scene->cameraClose.verticalFieldOfView = 0.7;
    scene->finish();
    return scene;
}

struct Options {
    bool asPublished = false, coverageMap = false;
};

std::unique_ptr<Technique> temporal(const Options& options) {
    std::unique_ptr<Technique> technique = makeTechnique("temporal", sharedRenderer().programs());
    setFromText(*technique, "as_published", options.asPublished ? "on" : "off");
    setFromText(*technique, "coverage_map", options.coverageMap ? "on" : "off");
    return technique;
}

double litShare(Scene& scene, const Options& options, int mapSize = 1024, int width = side, int height = side) {
    const std::unique_ptr<Technique> technique = temporal(options);
    sharedRenderer().draw(FramePlanner(scene).plan(ProceduralScene::request(width, height, strata, mapSize, 11)),
                          *technique, View::Visibility);
    const std::vector<float> lit = sharedRenderer().readVisibility();
    double sum = 0.0;
    for (const float value : lit) sum += static_cast<double>(value);
    return sum / static_cast<double>(lit.size());
}

double figure(const Technique& technique, const std::string& name) {
    for (const TechniqueStatistic& f : technique.statistics())
        if (f.name == name) return f.value;
    throw std::logic_error("no figure " + name);
}

/// A texel at z = 5 is 0.007 wide; speeds are 2.5 and more.
constexpr double tolerance = 2.0 * noise + 0.003;

TEST(Temporal, TranslationsAreExactInBothForms) {
    for (const bool asPublished : {false, true}) {
        SCOPED_TRACE(asPublished ? "as published" : "repaired");
        const Options options{asPublished, false};
        EXPECT_NEAR(litShare(*over({0, 0, 0}, {caster(-1.25, 1.25)}), options), 0.6, tolerance) << "quad_sweeps_point";
        EXPECT_NEAR(litShare(*over({0, 0, 0}, {caster(-1.25, 0)}), options), 0.6, tolerance) << "quad_enters";
        EXPECT_NEAR(litShare(*over({0, 0, 0}, {caster(-1, 4), caster(-3.5, 1.5)}), options), 0.6, 2.0 * tolerance)
            << "two_disjoint";
        EXPECT_NEAR(litShare(*over({0, 0, 0}, {caster(-1, 4), caster(-1.5, 3.5, 6)}), options), 0.7, tolerance)
            << "two_overlap";
        EXPECT_NEAR(
            litShare(*over({0, 0, 0}, {caster(-1.25, 1.25), caster(-1.25, 1.25), caster(-1.25, 1.25)}), options), 0.6,
            tolerance)
            << "triplicate";
        EXPECT_NEAR(litShare(*over({0, 0, 0}, {caster(-1.25, 1.25), caster(1.25, -1.25)}), options), 0.6, tolerance)
            << "opposite_motion";
        EXPECT_EQ(litShare(*over({0, 0, 0}, {triangle({{{-1, 0, 4}, {0, 0, 6}, {1, 0, 4}}},
                                                      {{{-1, 0, 5}, {0, 0, 7}, {1, 0, 5}}})}),
                           options),
                  1.0)
            << "edge_on";
        for (const char* name : {"light_slides", "receiver_slides", "light_and_receiver_slide"})
            EXPECT_NEAR(litShare(*closedFormCase(name).scene, options, 1024, 4, 128), closedFormCase(name).exact,
                        tolerance)
                << name;
    }
}

TEST(Temporal, ManySliversAddUp) {
    std::vector<MovingQuad> casters;
    const int count = 1000;
    const double speed = 20.0;
    for (int i = 0; i < count; ++i) {
        const double middle = (i + 0.25) / count;
        casters.push_back(
            slidingQuad({-speed * middle, 0, 5}, {speed * (1.0 - middle), 0, 5}, 0.25 * speed / count, -0.05, 0.05));
    }
    EXPECT_NEAR(litShare(*over({0.001, 0.002, 0.0}, casters), {}, 256), 0.5, 0.02);
}

TEST(Temporal, RepairedIsRightWhereTrianglesRotate) {
    for (const bool coverageMap : {false, true}) {
        const Options options{false, coverageMap};
        EXPECT_NEAR(litShare(*flipTriangle(), options), 0.14, tolerance);
        EXPECT_NEAR(litShare(*invertTriangle(), options), invertLit, tolerance);
        EXPECT_NEAR(litShare(*over({1.4, -1.4, 0.0}, {triangle({{{-.1, -.1, 5}, {.1, -.1, 5}, {0, .1, 5}}},
                                                               {{{-2, -2, 5}, {2, -2, 5}, {0, 2, 5}}})}),
                             options),
                    6.0 / 19.0, tolerance)
            << "vertex_path";
    }
}

TEST(Temporal, RepairedIsRightUnderPerspective) {
    EXPECT_NEAR(litShare(*rangeLerp(), {}), 0.5, 2.0 * noise + 0.001);
    EXPECT_NEAR(litShare(*over({0, 0, 0}, {slidingQuad({0, 0, 9.5}, {0, 0, 11}, 0.5, -0.4, 0.6)}), {}), 2.0 / 3.0,
                2.0 * noise)
        << "past_the_light";
}

/// Times are interpolated with perspective: a light that recedes is no difficulty.
TEST(Temporal, BothFormsFollowALightThatRecedes) {
    for (const bool asPublished : {false, true})
        EXPECT_NEAR(litShare(*lightRecedes(), {asPublished, false}), 2.0 / 3.0, 2.0 * noise + 0.004) << asPublished;
}

TEST(Temporal, PublishedFailsAsPredicted) {
    const Options published{true, false}, withCoverage{true, true};
    EXPECT_NEAR(litShare(*flipTriangle(), published), 0.0, 0.01)
        << "first and last: the gap between two coverage intervals is lost";
    EXPECT_NEAR(litShare(*invertTriangle(), published), 0.0, 0.01) << "the same";
    EXPECT_NEAR(litShare(*invertTriangle(), withCoverage), 0.0, 0.01)
        << "both ends cover, so it is taken to cover throughout";
    // 1 / d goes linearly from 1/2 to 1/20, and is 1/11 at u = 10/11.
    EXPECT_NEAR(litShare(*rangeLerp(), published), 1.0 / 11.0, 2.0 * noise + 0.001) << "NDC depth linear in time";
}

/// The triangle of case 14 covers the texel at both ends, and not between: the published coverage map claims it, the
/// repaired one must not.
TEST(Temporal, OnlyThePublishedCoverageMapClaimsWhatIsNotCovered) {
    const auto scene = invertTriangle();
    const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(4, 4, 2, 256, 1));
    const auto claims = [&](bool asPublished) {
        const std::unique_ptr<Technique> technique = temporal({asPublished, true});
        sharedRenderer().draw(plan, *technique, View::Visibility);
        return figure(*technique, "covered texels");
    };
    // The centre, where the triangle passes through a point at u = 0.5, is claimed by neither but in rounding.
    EXPECT_GT(claims(true), 100.0);
    EXPECT_EQ(claims(false), 0.0);
}

TEST(Temporal, ACubeTopIsLit) {
    const glm::dvec3 corner[8] = {{-.5, -.5, -.5}, {.5, -.5, -.5}, {.5, .5, -.5}, {-.5, .5, -.5},
                                  {-.5, -.5, .5},  {.5, -.5, .5},  {.5, .5, .5},  {-.5, .5, .5}};
    const int faces[6][4] = {{4, 5, 6, 7}, {3, 2, 1, 0}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    auto scene = over({0, 0, 0}, {});
    scene->quads.clear();
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
    scene->finish();
    EXPECT_EQ(litShare(*scene, {}), 1.0);
}

/// Without any bias, a sloping triangle that comes nearer is in front of half of its own points at their texels'
/// centres.
TEST(Temporal, ATriangleDoesNotShadowItself) {
    const Corners open{{{-1, -1, 1}, {1, -1, 1.5}, {0, 1, 2}}};
    Corners close = open;
    for (glm::dvec3& corner : close) corner.z += 2.0;
    auto scene = over({0, 0, 0}, {});
    scene->quads = {triangle(open, close)};
    scene->cameraOpen.eye = {0.0, 0.0, 3.0};
    scene->cameraClose.eye = {0.0, 0.0, 5.0};
    scene->cameraOpen.verticalFieldOfView = scene->cameraClose.verticalFieldOfView = 2.0 * std::atan(0.1);
    scene->finish();
    for (const bool asPublished : {false, true}) {
        const std::unique_ptr<Technique> technique = temporal({asPublished, false});
        setFromText(*technique, "bias", "0");
        setFromText(*technique, "slope_bias", "0");
        sharedRenderer().draw(FramePlanner(*scene).plan(ProceduralScene::request(32, 32, 4, 64, 1)), *technique,
                              View::Visibility);
        for (const float lit : sharedRenderer().readVisibility()) ASSERT_EQ(lit, 1.0f);
    }
}

std::vector<float> visibilityOf(const FramePlan& plan, Technique& technique) {
    sharedRenderer().draw(plan, technique, View::Visibility);
    return sharedRenderer().readVisibility();
}

/// Not one sample, whatever the bias; and some tuples must have been left out, or the test would show nothing.
TEST(Temporal, TheRepairedCoverageMapChangesNothing) {
    double spared = 0.0;
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        const auto scene = heap(seed);
        const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(160, 120, 8, 256, seed));
        const std::unique_ptr<Technique> without = temporal({false, false}), with = temporal({false, true});
        for (const char* bias : {"0", "0.5"}) {
            for (Technique* technique : {without.get(), with.get()}) {
                setFromText(*technique, "bias", bias);
                setFromText(*technique, "slope_bias", bias);
            }
            const std::vector<float> expected = visibilityOf(plan, *without), found = visibilityOf(plan, *with);
            EXPECT_EQ(expected, found) << "seed " << seed << ", bias " << bias;
            EXPECT_GT(std::count(expected.begin(), expected.end(), 0.0f), 1000);
        }
        EXPECT_EQ(figure(*with, "tuples") + figure(*with, "tuples skipped"), figure(*without, "tuples"));
        EXPECT_LE(figure(*with, "longest list"), figure(*without, "longest list"));
        spared += figure(*with, "tuples skipped");
    }
    EXPECT_GT(spared, 10000.0);
}

TEST(Temporal, TheSameFrameHasTheSameBytes) {
    const auto scene = heap(4);
    const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(160, 120, 8, 256, 1));
    for (const bool asPublished : {false, true}) {
        const std::unique_ptr<Technique> first = temporal({asPublished, true}), second = temporal({asPublished, true});
        const std::vector<float> expected = visibilityOf(plan, *first);
        EXPECT_EQ(expected, visibilityOf(plan, *first)) << "again";
        EXPECT_EQ(expected, visibilityOf(plan, *second)) << "with lists that grow anew";
    }
}

TEST(Temporal, MemoryIsWhatTheLayoutSays) {
    const auto scene = heap(5);
    const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(32, 24, 2, 512, 1));
    for (const bool asPublished : {false, true}) {
        for (const bool coverageMap : {false, true}) {
            const std::unique_ptr<Technique> technique = temporal({asPublished, coverageMap});
            sharedRenderer().draw(plan, *technique, View::Visibility);
            EXPECT_GT(figure(*technique, "tuples"), 100000.0);
            EXPECT_NEAR(figure(*technique, "memory predicted") / static_cast<double>(technique->bytes()), 1.0, 0.05)
                << asPublished << coverageMap;
        }
    }
}

TEST(Temporal, ViewsShowTheTexelsOfTheReceivers) {
    const auto scene = over(
        {0, 0, 0}, {caster(-1.25, 0), caster(-1.25, 0, 6), caster(-1.25, 0, 7)});  // there from u = 0.6 on, and near it
    const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(8, 8, 2, 256, 1));
    for (const bool asPublished : {false, true}) {
        const std::unique_ptr<Technique> technique = temporal({asPublished, false});
        sharedRenderer().draw(plan, *technique, View::Final, "tuples");
        const LinearImage tuples = sharedRenderer().readRadiance();
        // A quad is two triangles; the point is covered by one of them or, one after the other, by both.
        for (const float value : tuples.rgb) {
            EXPECT_GE(value, 3.0f);
            EXPECT_LE(value, 6.0f);
        }
        sharedRenderer().draw(plan, *technique, View::Final, "time");
        const LinearImage times = sharedRenderer().readRadiance();
        for (const float value : times.rgb) EXPECT_NEAR(value, 0.4, 0.25);
    }
}

}  // namespace

}  // namespace timeshade
