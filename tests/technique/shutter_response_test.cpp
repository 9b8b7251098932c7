// Pictures and measurements where the shutter does not respond alike to all instants: against closed forms, and against
// each other.
#include <cmath>
#include <filesystem>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cases/closed_form_cases.h"
#include "measure/made_with.h"
#include "measure/reference.h"
#include "measure/verification.h"
#include "support/gl_environment.h"
#include "technique/history_scenes.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

constexpr int width = 12, height = 128;

/// The response, the lit share of a point that is dark from .3 to .7 of the shutter, and w(.3) over the mean of w.
struct Expected {
    ShutterResponse response;
    double gaussianWidth, lit, weightAtEnds;
};

double gaussianDark(double deviation) { return std::erf(0.2 / std::sqrt(2.0) / deviation); }
double gaussianWhole(double deviation) { return std::erf(0.5 / std::sqrt(2.0) / deviation); }

Expected gaussian(double deviation) {
    const double mean = deviation * std::sqrt(2.0 * 3.14159265358979) * gaussianWhole(deviation);
    return {ShutterResponse::Gaussian, deviation, 1.0 - gaussianDark(deviation) / gaussianWhole(deviation),
            std::exp(-0.5 * 0.04 / (deviation * deviation)) / mean};
}

const std::vector<Expected> responses{{ShutterResponse::Box, 1.0 / 6.0, 0.6, 1.0},
                                      {ShutterResponse::Tent, 1.0 / 6.0, 0.36, 1.2},
                                      gaussian(1.0 / 6.0),
                                      gaussian(0.3),
                                      gaussian(2.0)};

FrameRequest requestOf(const Expected& e, int samplesPerPixel, std::uint32_t seed = 1) {
    FrameRequest request = ProceduralScene::request(width, height, samplesPerPixel, 1024, seed);
    request.shutter.response = e.response;
    request.shutter.width = e.gaussianWidth;
    return request;
}

FramePlan planOf(Scene& scene, const Expected& e, int samplesPerPixel, std::uint32_t seed = 1) {
    return FramePlanner(scene).plan(requestOf(e, samplesPerPixel, seed));
}

std::vector<double> values(const LinearImage& image) {
    std::vector<double> red;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) red.push_back(static_cast<double>(image.rgb[i]));
    return red;
}

double mean(const std::vector<double>& all) {
    return std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
}

double litShare(Technique& technique, const FramePlan& plan) {
    sharedRenderer().draw(plan, technique, View::Visibility);
    return mean(values(sharedRenderer().readRadiance()));
}

std::unique_ptr<Technique> made(const std::string& name) { return makeTechnique(name, sharedRenderer().programs()); }

/// Half a texel of the map at the caster's depth, as a share of the shutter: at both ends of the shadow.
constexpr double mapError = 2.0 * 0.5 * 5.0 * 2.0 * 0.714 / 1024 / 2.5;

TEST(ShutterResponse, AccumulationComesToTheClosedForm) {
    Scene& scene = *closedFormCase("quad_sweeps_point").scene;
    const auto technique = made("accumulation");
    for (const int renders : {16, 256})
        for (const Expected& e : responses) {
            setFromText(*technique, "renders", std::to_string(renders));
            // Either end of the shadow falls anywhere between two instants.
            EXPECT_NEAR(litShare(*technique, planOf(scene, e, 1)), e.lit,
                        e.weightAtEnds * (1.0 / renders + mapError) + 1e-4)
                << renders << " renders, response " << static_cast<int>(e.response) << " " << e.gaussianWidth;
        }
}

/// The lit share of that point by the quotient of so many samples at stratified times, in the mean: what the closed
/// form is missed by is the quotient's bias. By simulation, so within 2e-4.
double quotientOf(const Expected& e, int samples) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> xi;
    const auto weightOf = [&](double u) {
        if (e.response == ShutterResponse::Box) return 1.0;
        if (e.response == ShutterResponse::Tent) return 1.0 - std::abs(2.0 * u - 1.0);
        return std::exp(-0.5 * (u - 0.5) * (u - 0.5) / (e.gaussianWidth * e.gaussianWidth));
    };
    const int pixels = 2000000 / samples;
    double sum = 0.0;
    for (int pixel = 0; pixel < pixels; ++pixel) {
        double lit = 0.0, weights = 0.0;
        for (int k = 0; k < samples; ++k) {
            const double u = (k + xi(random)) / samples, weight = weightOf(u);
            weights += weight;
            if (u < 0.3 || u > 0.7) lit += weight;
        }
        sum += lit / weights;
    }
    return sum / pixels;
}

/// Exact shadows at stratified times: what is left is noise, and the bias of a quotient of two sums.
TEST(ShutterResponse, ExactSamplesComeToTheClosedForm) {
    Scene& scene = *closedFormCase("quad_sweeps_point").scene;
    const auto technique = made("exact");
    for (const int samples : {4, 8, 32})
        for (const Expected& e : responses) {
            std::vector<double> pixels;
            for (std::uint32_t seed = 1; seed <= 4; ++seed) {
                sharedRenderer().draw(planOf(scene, e, samples, seed), *technique, View::Visibility);
                const std::vector<double> more = values(sharedRenderer().readRadiance());
                pixels.insert(pixels.end(), more.begin(), more.end());
            }
            const double found = mean(pixels), expected = quotientOf(e, samples);
            double squares = 0.0;
            for (const double pixel : pixels) squares += (pixel - found) * (pixel - found);
            const double noise = std::sqrt(squares) / static_cast<double>(pixels.size());
            SCOPED_TRACE(testing::Message()
                         << samples << " samples, response " << static_cast<int>(e.response) << " " << e.gaussianWidth);
            // The patch has a width: ends of the shadow reach its sides 1e-4 apart.
            EXPECT_NEAR(found, expected, 4.0 * noise + 4e-4);
            EXPECT_LT(noise, samples == 4 ? 4e-3 : 2e-3);
            // A box has none. With eight times as many samples it is some hundred times less.
            EXPECT_NEAR(expected, e.lit, samples == 4 ? 0.03 : samples == 8 ? 0.005 : 3e-4);
        }
}

/// Every technique that is right for this case without a response is right with each.
TEST(ShutterResponse, EveryTechniqueComesToTheClosedForm) {
    Scene& scene = *closedFormCase("quad_sweeps_point").scene;
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        const auto technique = made(description.name);
        if (technique->renders() > 1) setFromText(*technique, "renders", "64");
        if (technique->samplingTraits().times == SamplingTraits::Times::OneInstant && technique->renders() == 1)
            continue;  // one instant for all
        for (const Expected& e : {responses[0], responses[1], responses[2]}) {
            FrameRequest request = requestOf(e, 16);
            request.mapSize = 512;  // half a texel is .006 of the shutter
            const double share = litShare(*technique, FramePlanner(scene).plan(request));
            EXPECT_NEAR(share, e.lit, 0.02) << description.name << ", response " << static_cast<int>(e.response);
        }
    }
}

/// One stratum is the whole shutter: those that average within it have nothing but their own weights.
TEST(ShutterResponse, MeansWithinAStratumAreWeighted) {
    Scene& scene = *closedFormCase("quad_sweeps_point").scene;
    std::size_t tested = 0;
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        const auto technique = made(description.name);
        if (technique->footprint().time != Footprint::Time::Stratum) continue;
        ++tested;
        for (const Expected& e : {responses[0], responses[1], responses[2]}) {
            double share = 0.0;
            for (std::uint32_t seed = 1; seed <= 2; ++seed)
                share += 0.5 * litShare(*technique, planOf(scene, e, 1, seed));
            // Of four times those outside of the shadow count for .25 and .095 instead of .36 and .23. Without weights
            // it is .6, whatever the response.
            EXPECT_NEAR(share, e.lit, 0.15) << description.name << ", response " << static_cast<int>(e.response);
        }
    }
    EXPECT_GE(tested, 2u);
}

TEST(ShutterResponse, WhatDoesNotChangeKeepsItsColour) {
    Scene& scene = *closedFormCase("approaching_self").scene;  // lit throughout
    const auto technique = made("exact");
    for (const Expected& e : responses)
        for (const int samples : {1, 2, 7, 32}) {
            sharedRenderer().draw(planOf(scene, e, samples), *technique, View::Visibility);
            for (const double pixel : values(sharedRenderer().readRadiance())) ASSERT_EQ(pixel, 1.0);
        }
}

TEST(ShutterResponse, AStaticSceneHasTheSameBytes) {
    const auto scene = boardScene();
    FramePlanner planner(*scene);
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        std::vector<std::vector<float>> pictures;
        for (const Expected& e : responses) {
            const auto technique = made(description.name);
            if (technique->renders() > 1) setFromText(*technique, "renders", "5");
            sharedRenderer().draw(planner.plan(requestOf(e, 6)), *technique, View::Final);
            pictures.push_back(sharedRenderer().readRadiance().rgb);
            EXPECT_TRUE(pictures.back() == pictures.front()) << description.name;
        }
    }
}

/// The picture so far of a frame that is drawn render by render is one of the whole frame's brightness.
TEST(ShutterResponse, APictureInTheMakingIsAsBrightAsTheWhole) {
    Scene& scene = *closedFormCase("approaching_self").scene;
    const auto technique = made("accumulation");
    setFromText(*technique, "renders", "5");
    for (const Expected& e : responses) {
        sharedRenderer().begin(planOf(scene, e, 1), *technique, View::Visibility);
        for (int done = 1; done <= 5; ++done) {
            sharedRenderer().step();
            for (const double pixel : values(sharedRenderer().readRadiance()))
                ASSERT_NEAR(pixel, 1.0, 1e-6) << done << " of 5 renders";
        }
    }
}

/// The oracle's pixels, the picture of the reference and the technique's own means are all of one response.
TEST(ShutterResponse, ErrorsAreTakenWithIt) {
    Scene& scene = *closedFormCase("quad_sweeps_point").scene;
    const auto technique = made("exact");
    for (const Expected& e : responses) {
        const FramePlan plan = planOf(scene, e, 32);
        VerificationOptions options;
        options.reference = referenceVisibility(plan, 256, ReferenceCache(std::filesystem::path()));
        const double first = static_cast<double>(
            std::accumulate(options.reference->first.begin(), options.reference->first.end(), 0.0f));
        EXPECT_NEAR(first / (width * height), e.lit, 1e-3) << "the oracle's";
        const Verification v = verifyFrame(sharedRenderer(), plan, *technique, options);
        // Two ends of a shadow, each in one of 32 strata: up to 2^.5 / 2 / 32 = .022 of the exposure if all alike.
        EXPECT_LT(v.shadowError->error.rms, 0.024 * e.weightAtEnds);
        EXPECT_EQ(v.disagree(), 0u);
        // By a reference of another response it is off by the whole difference.
        const Expected& other = e.response == ShutterResponse::Box ? responses[1] : responses[0];
        options.reference = referenceVisibility(planOf(scene, other, 32), 256, ReferenceCache(std::filesystem::path()));
        const Verification w = verifyFrame(sharedRenderer(), plan, *technique, options);
        EXPECT_NEAR(w.shadowError->error.mean, std::abs(e.lit - other.lit), 0.02);
    }
}

TEST(ShutterResponse, AccumulationsErrorIsTakenWithItsWeights) {
    Scene& scene = *closedFormCase("quad_sweeps_point").scene;
    const auto technique = made("accumulation");
    setFromText(*technique, "renders", "64");
    for (const Expected& e : responses) {
        const FramePlan plan = planOf(scene, e, 1);
        VerificationOptions options;
        options.reference = referenceVisibility(plan, 256, ReferenceCache(std::filesystem::path()));
        EXPECT_LT(verifyFrame(sharedRenderer(), plan, *technique, options).shadowError->error.rms,
                  e.weightAtEnds * (1.0 / 64 + mapError));
    }
}

TEST(ShutterResponse, ReferencePicturesComeToTheClosedForm) {
    Scene& scene = *closedFormCase("quad_sweeps_point").scene;
    ReferenceCache cache{std::filesystem::path()};
    ReferenceOptions options;
    options.samplesPerPixel = 64;
    options.view = View::Visibility;
    for (const Expected& e : responses) {
        const LinearImage image = referenceImage(sharedRenderer(), planOf(scene, e, 4), options, cache);
        EXPECT_NEAR(mean(values(image)), e.lit, 1e-3);
    }
}

TEST(ShutterResponse, IsPartOfEveryKey) {
    Scene& moving = *closedFormCase("quad_sweeps_point").scene;
    Scene& still = *closedFormCase("static_all").scene;
    for (std::size_t i = 0; i < responses.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const FramePlan a = planOf(moving, responses[i], 4), b = planOf(moving, responses[j], 4);
            EXPECT_NE(referenceKey(a, {}), referenceKey(b, {}));
            EXPECT_NE(referenceVisibilityKey(a, 64), referenceVisibilityKey(b, 64));
            EXPECT_NE(madeWithScene(moving, a.request), madeWithScene(moving, b.request));
            // Where nothing moves the pictures are one and the same.
            const FramePlan c = planOf(still, responses[i], 4), d = planOf(still, responses[j], 4);
            EXPECT_EQ(referenceKey(c, {}), referenceKey(d, {}));
            EXPECT_EQ(referenceVisibilityKey(c, 64), referenceVisibilityKey(d, 64));
        }
    Expected tent = responses[1];
    const FramePlan narrow = planOf(moving, tent, 4);
    tent.gaussianWidth = 0.5;
    EXPECT_EQ(referenceKey(narrow, {}), referenceKey(planOf(moving, tent, 4), {})) << "a tent has no width";
}

/// A moment that is held: the instants of the history's map lie as densely as the shutter responds.
TEST(ShutterResponse, AHeldHistoryComesToTheClosedForm) {
    Scene& scene = *closedFormCase("quad_sweeps_point").scene;
    for (const Expected& e : responses) {
        const auto technique = makeHistory();
        setFromText(*technique, "fit", "0");
        const FramePlan plan = planOf(scene, e, 4);
        technique->forget();
        double share = 0.0;
        for (int frame = 0; frame < 200; ++frame) share = litShare(*technique, plan);
        // The first frame, of the shutter's middle, is one of 200; either end of the shadow lies between two of them.
        EXPECT_NEAR(share, e.lit, 0.02) << static_cast<int>(e.response) << " " << e.gaussianWidth;
    }
}

TEST(ShutterResponse, AHistoryBeginsAnewWithAnother) {
    Scene& scene = *closedFormCase("quad_sweeps_point").scene;
    FramePlanner planner(scene);
    const auto technique = makeHistory(), fresh = makeHistory();
    for (int frame = 0; frame < 20; ++frame) litShare(*technique, planner.plan(requestOf(responses[0], 4)));
    const FramePlan tent = planner.plan(requestOf(responses[1], 4));
    sharedRenderer().draw(tent, *technique, View::Visibility);
    const std::vector<float> after = sharedRenderer().readVisibility();
    sharedRenderer().draw(tent, *fresh, View::Visibility);
    EXPECT_EQ(after, sharedRenderer().readVisibility());
}

/// No cache of the frame holds on to a response that is no longer asked for.
TEST(ShutterResponse, IsTakenUpFromOneFrameToTheNext) {
    const auto scene = boardScene({0.3, 0.0, 0.0});
    FramePlanner planner(*scene);
    FrameRenderer cold;  // but for its programs
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        const auto technique = made(description.name);
        if (technique->renders() > 1) setFromText(*technique, "renders", "5");
        if (technique->warmUpFrames() > 0) continue;  // remembers earlier frames because that is what it is
        for (const std::size_t i : {0u, 0u, 1u, 2u, 3u, 0u}) {
            FrameRequest request = requestOf(responses[i], 6);
            request.mapSize = 128;
            const FramePlan plan = planner.plan(request);
            sharedRenderer().draw(plan, *technique, View::Final);
            const LinearImage after = sharedRenderer().readRadiance();
            cold.invalidateAll();
            const auto alone = makeTechnique(description.name, cold.programs());
            if (alone->renders() > 1) setFromText(*alone, "renders", "5");
            cold.draw(plan, *alone, View::Final);
            EXPECT_TRUE(after.rgb == cold.readRadiance().rgb) << description.name << ", response " << i;
        }
    }
}

}  // namespace
}  // namespace timeshade
