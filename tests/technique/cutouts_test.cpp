// What alpha cuts out of a triangle lets light and eyes through, in every technique, as the oracle decides by its own
// arithmetic.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cases/procedural_scene.h"
#include "core/error.h"
#include "measure/reference.h"
#include "measure/reference_technique.h"
#include "measure/verification.h"
#include "support/cutout_scene.h"
#include "support/drawn_here.h"
#include "support/gl_environment.h"
#include "support/lit_centres.h"
#include "support/thorough.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

FramePlan planOf(const Scene& scene, int width, int samples, int map, std::uint32_t seed) {
    return FramePlanner(scene).plan(ProceduralScene::request(width, width / 4 * 3, samples, map, seed));
}

Verification verified(const Scene& scene, const std::string& technique, int width, int samples) {
    const std::unique_ptr<Technique> made = makeTechnique(technique, sharedRenderer().programs());
    return verifyFrame(sharedRenderer(), planOf(scene, width, samples, 256, 3), *made, {});
}

struct Named {
    const char* name;
    CutoutSceneOptions options;
};

class Cutouts : public DrawnHere<Named> {};

/// Not more than 10 in a million, of the camera's triangles none but where a float's rounding decides.
TEST_P(Cutouts, ExactAgreesWithTheOracle) {
    const Verification v = verified(*makeCutoutScene(GetParam().options), "exact", 320, 4);
    EXPECT_GT(v.tested, 100000u);
    EXPECT_GT(v.shadowed, 4000u);
    EXPECT_LE(v.ppm(), 10.0) << v.falseShadow << " false shadow, " << v.falseLit << " false lit of " << v.tested;
    EXPECT_EQ(v.primaryDisagree, 0u) << "of " << v.primaryTested;
    CutoutSceneOptions whole = GetParam().options;
    whole.cutsOut = false;
    const Verification without = verified(*makeCutoutScene(whole), "exact", 320, 4);
    EXPECT_LT(static_cast<double>(v.shadowed), 0.9 * static_cast<double>(without.shadowed))
        << "as if nothing were cut out";
    RecordProperty("ppm", std::to_string(v.ppm()));
}

std::vector<Named> allScenes() {
    return {{"spot", {}},
            {"sun", {.sun = true}},
            {"still_cards", {.sun = true, .cardsMove = false}},
            {"still_light", {.lightMoves = false}},
            {"all_still", {.lightMoves = false, .cardsMove = false}},
            {"camera", {.sun = true, .cameraMoves = true}},
            {"tilted", {.tilted = true}},
            {"low_cutoff", {.cutoff = 0.1f}},
            {"high_cutoff", {.sun = true, .cutoff = 0.9f}},
            {"repeated", {.repeats = 2.5f, .wrap = Wrap::Repeat}},
            {"mirrored", {.sun = true, .repeats = 1.5f, .wrap = Wrap::Mirror}},
            {"nearest", {.repeats = 1.5f, .wrap = Wrap::Repeat, .nearest = true}},
            {"box", {.repeats = 1.0f, .wrap = Wrap::Repeat, .closed = true}}};
}

INSTANTIATE_TEST_SUITE_P(Scenes, Cutouts, testing::ValuesIn(allScenes()),
                         [](const auto& given) { return std::string(given.param.name); });

constexpr int width = 112, map = 384;

/// Mean light of each pixel.
std::vector<double> drawn(const Scene& scene, Technique& technique, int samples, std::uint32_t seed) {
    sharedRenderer().draw(planOf(scene, width, samples, map, seed), technique, View::Visibility);
    const LinearImage picture = sharedRenderer().readRadiance();
    std::vector<double> light;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) light.push_back(static_cast<double>(picture.rgb[i]));
    return light;
}

double rms(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> all;
    for (std::size_t i = 0; i < a.size(); ++i) all.push_back(a[i] - b[i]);
    return all;
}

class CutoutsOf : public DrawnHere<std::string> {};

/// With these switches on. Null where it has no such switch.
std::unique_ptr<Technique> made(const std::string& name, const std::string& switches) {
    std::unique_ptr<Technique> technique = makeTechnique(name, sharedRenderer().programs());
    std::istringstream keys(switches);
    for (std::string key; keys >> key;) {
        const std::vector<Setting> settings = settingsOf(*technique);
        if (std::none_of(settings.begin(), settings.end(), [&](const Setting& s) { return s.key == key; }))
            return nullptr;
        setFromText(*technique, key, "on");
    }
    return technique;
}

/// Against the truth on the same camera samples: a technique errs little more than where the cards are whole, as its
/// shadows have more edges, and what is cut out changes its picture as it changes the truth.
void expectTheLeafsShadow(Technique& technique) {
    for (const bool sun : {false, true}) {
        const std::unique_ptr<Scene> leaves = makeCutoutScene({.sun = sun, .cutoff = 0.4f}),
                                     whole = makeCutoutScene({.sun = sun, .cutsOut = false});
        if (technique.unsupported(planOf(*leaves, width, 8, map, 1))) continue;
        ReferenceTechnique truth, wholeTruth;
        const std::vector<double> right = drawn(*leaves, truth, 8, 1), wholeRight = drawn(*whole, wholeTruth, 8, 1);
        const std::vector<double> leaf = drawn(*leaves, technique, 8, 1);
        technique.forget();
        const std::vector<double> card = drawn(*whole, technique, 8, 1);
        const double error = rms(leaf, right), wholeError = rms(card, wholeRight);
        EXPECT_LT(error, 2.5 * wholeError + 0.01);
        // What is cut out changes the picture by so much, and what it changes is off by so much. One that is blind to
        // it is off by all of the change; one map for the whole shutter by .55 of it. What shadows itself does so
        // differently where there are holes.
        const double change = rms(wholeRight, right);
        const double off = rms(difference(leaf, card), difference(right, wholeRight));
        EXPECT_LT(off, 0.65 * change + 0.1 * wholeError) << (sun ? "sun" : "spot");
    }
}

TEST_P(CutoutsOf, CastTheLeafsShadow) {
    const char* const all[] = {"", "as_published coverage_map", "as_published", "coverage_map"};
    for (std::size_t i = 0; i < usualOrAll<std::size_t>(2, std::size(all)); ++i) {
        SCOPED_TRACE(all[i]);
        if (const std::unique_ptr<Technique> technique = made(GetParam(), all[i])) expectTheLeafsShadow(*technique);
    }
}

std::vector<std::string> allNames() {
    std::vector<std::string> names;
    for (const TechniqueDescription& description : techniqueDescriptions()) names.push_back(description.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Techniques, CutoutsOf, testing::ValuesIn(allNames()),
                         [](const testing::TestParamInfo<std::string>& tested) { return tested.param; });

/// Interval samples solve for edges, of which the outline of a leaf has none.
TEST(CutoutsOfIntervalSamples, AreRefusedByTheMaterialsName) {
    const std::unique_ptr<Scene> scene = makeCutoutScene({});
    FrameRequest request = ProceduralScene::request(32, 24, 2, 64, 1);
    request.samples = CameraSamples::Intervals;
    try {
        FramePlanner(*scene).plan(request);
        FAIL() << "was planned";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("\"leaf\""), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("strata"), std::string::npos) << error.what();
    }
}

std::vector<double> litCentres(const Scene& scene, const FrameRequest& request, const std::string& technique) {
    return litAtCentres(scene, request, *makeTechnique(technique, sharedRenderer().programs()), 4);
}

/// Where the camera sees only what they shadow, lit times are solved: against `exact` at 128 instants of each pixel's
/// centre.
TEST(CutoutsOfIntervalSamples, CastTheirShadow) {
    for (const bool sun : {false, true}) {
        const std::unique_ptr<Scene> scene = makeCutoutScene({.sun = sun}),
                                     whole = makeCutoutScene({.sun = sun, .cutsOut = false});
        FrameRequest request = ProceduralScene::request(64, 48, 32, 512, 1);
        request.cameraPose = belowTheCards();
        request.pixelCentres = true;
        const std::vector<double> truth = litCentres(*scene, request, "exact");
        request.samplesPerPixel = 1;
        request.samples = CameraSamples::Intervals;
        EXPECT_GT(rms(litCentres(*whole, request, "integral"), truth), 0.1) << "nothing is cut out";
        EXPECT_LT(rms(litCentres(*scene, request, "integral"), truth), 0.01);
        EXPECT_LT(rms(litCentres(*scene, request, "intervals"), truth), 0.03);
    }
}

/// A reference that was drawn of other holes is another one's.
TEST(CutoutReference, IsKeyedByWhatIsCutOut) {
    const auto keyOf = [](const CutoutSceneOptions& options) {
        return referenceKey(planOf(*makeCutoutScene(options), 32, 2, 64, 1), {});
    };
    const std::string key = keyOf({});
    EXPECT_EQ(key, keyOf({}));
    EXPECT_NE(key, keyOf({.cutsOut = false}));
    EXPECT_NE(key, keyOf({.cutoff = 0.9f}));
    EXPECT_NE(key, keyOf({.nearest = true}));
    EXPECT_NE(key, keyOf({.wrap = Wrap::Repeat}));
}

}  // namespace
}  // namespace timeshade
