// The two errors of a technique, by test doubles whose values are known: a right one has a footprint error of 0, a
// converged one a shadow error of 0, and a wrong one what follows from its values.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>

#include <unistd.h>

#include <gtest/gtest.h>

#include "cases/procedural_scene.h"
#include "measure/error_summary.h"
#include "measure/verification.h"
#include "shared/shutter_response.shared.h"
#include "support/awkward_numbers.h"
#include "support/given_visibility_technique.h"
#include "support/gl_environment.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

constexpr int width = 48, height = 36, strata = 4;

/// Quads that fly and turn over a ground that slides; light and camera move too.
class MovingEverything {
  public:
    MovingEverything() {
        AwkwardNumbers numbers(5);
        const auto number = [&](float low, float high) { return static_cast<double>(numbers.between(low, high)); };
        for (int i = 0; i < 14; ++i) {
            const double x = number(-3, 3), y = number(-3, 3), z = number(1, 4), move = number(-1.5f, 1.5f),
                         rise = number(-0.5f, 0.5f), size = number(0.3f, 0.9f);
            scene_.quads.push_back(slidingQuad({x, y, z}, {x + move, y - move, z + rise}, size, -size, size));
        }
        scene_.quads.push_back(slidingQuad({0, 0, 0}, {0.4, 0, 0}, 7.0, -7.0, 7.0));
        scene_.cameraOpen = scene_.cameraClose = lookAt({2.0, -8.0, 7.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, 0.8, 0.01);
        scene_.cameraClose.eye.x += 0.1;
        scene_.lightOpen.position = {-0.5, 0.3, 11.0};
        scene_.lightClose.position = {0.8, 0.0, 11.0};
        scene_.lightOpen.outerConeAngle = scene_.lightClose.outerConeAngle = 0.45;
        scene_.finish();
        FramePlanner planner(scene_);
        FrameRequest request = ProceduralScene::request(width, height, strata, 128, 9);
        for (const auto response : {ShutterResponse::Box, ShutterResponse::Tent, ShutterResponse::Gaussian}) {
            request.shutter.response = response;
            plans.push_back(planner.plan(request));
        }
    }

    std::vector<FramePlan> plans;  ///< the same frame with each of the shutter's responses; the first is a box's

  private:
    ProceduralScene scene_;
};

const std::vector<FramePlan>& thePlans() {
    static const MovingEverything everything;
    return everything.plans;
}

const FramePlan& thePlan() { return thePlans().front(); }

Footprint over(Footprint::Time time, Footprint::Space space = Footprint::Space::Point) {
    Footprint footprint;
    footprint.time = time;
    footprint.space = space;
    return footprint;
}

/// All samples are compared, by 128 rays each.
VerificationOptions allSamples() {
    VerificationOptions options;
    options.checkPrimaries = false;
    options.footprint.samples = width * height * strata;
    options.footprint.rays = 128;
    return options;
}

/// Means of two halves, and what the differences of these say of their noise.
class Halves {
  public:
    float mean(std::size_t pixel, const VisibilityMean& a, const VisibilityMean& b) {
        if (!a.exists() || !b.exists()) return 0.0f;
        const double half = 0.5 * (a.value() - b.value());
        noise_.add(pixel, half, half);
        return static_cast<float>(0.5 * (a.value() + b.value()));
    }
    /// An error is this noise and nothing else, as far as anyone can tell.
    void expectNoiseAlone(const ErrorSummary& e) const {
        const ErrorSummary noise = noise_.summary();
        // A sliver of a surface in a pixel may be met by the rays of the one and not of the other.
        EXPECT_NEAR(static_cast<double>(e.count), static_cast<double>(noise.count), 3.0);
        EXPECT_LE(std::abs(e.meanSquare - noise.meanSquare),
                  3.0 * std::hypot(e.meanSquareDeviation, noise.meanSquareDeviation));
    }

  private:
    ErrorSum noise_{width * height};
};

/// The oracle's mean over the footprint of each sample that is tested: that of the two seeds, as verify takes it.
GivenVisibilityTechnique meansOf(const Footprint& footprint, std::uint32_t firstSeed, std::uint32_t secondSeed,
                                 const std::shared_ptr<Halves>& halves = std::make_shared<Halves>()) {
    return {footprint, [=](const Oracle& oracle, const FramePlan& plan, const std::vector<std::uint32_t>& ids) {
                const std::vector<OracleAnswer> answers = oracle.answer(plan, ids);
                std::vector<SampleFootprint> footprints(ids.size());
                for (std::uint32_t i = 0; i < ids.size(); ++i) {
                    SampleFootprint& o = footprints[i];
                    o.sample = {i % width, i / width % height, i / (width * height)};
                    o.triangle = answers[i].tested ? ids[i] : NO_TRIANGLE;
                    if (footprint.space == Footprint::Space::PixelSurface)
                        o.space = SampleFootprint::Space::PixelSurface;
                    if (footprint.time == Footprint::Time::Instant) o.from = o.to = answers[i].time;
                    if (footprint.time != Footprint::Time::Stratum) continue;
                    o.from = static_cast<float>(o.sample.stratum) / strata;
                    o.to = static_cast<float>(o.sample.stratum + 1) / strata;
                }
                const std::vector<VisibilityMean> a = oracle.footprintMeans(plan, footprints, 64, firstSeed),
                                                  b = oracle.footprintMeans(plan, footprints, 64, secondSeed);
                std::vector<float> lit(ids.size());
                for (std::size_t i = 0; i < lit.size(); ++i) lit[i] = halves->mean(i % (width * height), a[i], b[i]);
                return lit;
            }};
}

const Footprint kinds[] = {over(Footprint::Time::Instant),
                           over(Footprint::Time::Stratum),
                           over(Footprint::Time::Shutter),
                           over(Footprint::Time::Instant, Footprint::Space::PixelSurface),
                           over(Footprint::Time::Stratum, Footprint::Space::PixelSurface),
                           over(Footprint::Time::Shutter, Footprint::Space::PixelSurface)};

/// Each footprint, with each response of the shutter.
void forAllFootprints(const std::function<void(const Footprint&, const FramePlan&)>& check) {
    for (const FramePlan& plan : thePlans())
        for (const Footprint& footprint : kinds) {
            SCOPED_TRACE(static_cast<int>(&footprint - kinds));
            SCOPED_TRACE(static_cast<int>(plan.request.shutter.response));
            check(footprint, plan);
        }
}

TEST(FootprintError, OfTheExactMeanIsNothing) {
    forAllFootprints([](const Footprint& footprint, const FramePlan& plan) {
        GivenVisibilityTechnique exact =
            meansOf(footprint, FootprintErrorSum::firstSeed, FootprintErrorSum::secondSeed);
        const Verification v = verifyFrame(sharedRenderer(), plan, exact, allSamples());
        const ErrorSummary& e = v.footprintError.error;
        EXPECT_EQ(v.footprint.time, footprint.time);
        EXPECT_GT(e.count, 3500u);
        EXPECT_EQ(v.footprintError.rays, footprint.isBinary() ? 0u : 128u);
        // The very rays of verify: the visibility buffer's float is all that is between them.
        EXPECT_LE(e.p999, 6e-8);
        EXPECT_LE(e.mean, 6e-8);
        // Products of two such differences; of means over a box's rays they cancel altogether.
        EXPECT_LE(e.rms, plan.block.response == SHUTTER_BOX ? 0.0 : 6e-8);
    });
}

TEST(FootprintError, OfAnIndependentMeanIsItsNoiseAlone) {
    forAllFootprints([](const Footprint& footprint, const FramePlan& plan) {
        const auto halves = std::make_shared<Halves>();
        GivenVisibilityTechnique other = meansOf(footprint, 17, 18, halves);
        const Verification v = verifyFrame(sharedRenderer(), plan, other, allSamples());
        const ErrorSummary& e = v.footprintError.error;
        // The noise of verify's rays averages out; that of the double's own is left, and known by its halves.
        halves->expectNoiseAlone(e);
        if (!footprint.isBinary()) {
            EXPECT_GT(e.mean, 0.0);
        }
    });
}

/// The means of a box's shutter, or of a stratum of it, are not those of a tent.
TEST(FootprintError, OfMeansOfAnotherResponseIsSeen) {
    for (const Footprint& footprint : {kinds[1], kinds[2], kinds[4], kinds[5]}) {
        const GivenVisibilityTechnique means =
            meansOf(footprint, FootprintErrorSum::firstSeed, FootprintErrorSum::secondSeed);
        const auto ofABox = [&](const Oracle& oracle, const FramePlan& plan, const std::vector<std::uint32_t>& ids) {
            FramePlan box = plan;
            box.block.response = SHUTTER_BOX;
            return means.values()(oracle, box, ids);
        };
        GivenVisibilityTechnique wrong(footprint, ofABox);
        const ErrorSummary e = verifyFrame(sharedRenderer(), thePlans()[1], wrong, allSamples()).footprintError.error;
        EXPECT_GT(e.meanSquare, 10.0 * e.meanSquareDeviation);
        EXPECT_GT(e.rms, footprint.time == Footprint::Time::Stratum ? 0.01 : 0.03);
    }
}

/// A footprint that is declared wrongly is an error: each kind's mean, compared as if it were the next kind's.
TEST(FootprintError, ToldFromOneFootprintToTheNext) {
    for (std::size_t i = 0; i + 1 < std::size(kinds); ++i) {
        const GivenVisibilityTechnique means =
            meansOf(kinds[i], FootprintErrorSum::firstSeed, FootprintErrorSum::secondSeed);
        GivenVisibilityTechnique wrong(kinds[i + 1], means.values());
        const Verification v = verifyFrame(sharedRenderer(), thePlan(), wrong, allSamples());
        SCOPED_TRACE(static_cast<int>(i));
        EXPECT_GT(v.footprintError.error.meanSquare, 10.0 * v.footprintError.error.meanSquareDeviation);
        EXPECT_GT(v.footprintError.error.rms, 0.05);
    }
}

TEST(FootprintError, OfAHalfIsAHalfWhereTheTruthIsAnInstant) {
    for (const double filterTexels : {0.0, 3.0}) {
        Footprint footprint;
        footprint.filterTexels = filterTexels;  // a blur is no part of the truth
        GivenVisibilityTechnique half(footprint, [](const Oracle&, const FramePlan&, const auto& ids) {
            return std::vector<float>(ids.size(), 0.5f);
        });
        const Verification v = verifyFrame(sharedRenderer(), thePlan(), half, allSamples());
        EXPECT_EQ(v.footprintError.error.count, v.tested);
        EXPECT_EQ(v.footprintError.error.mean, 0.5);
        EXPECT_EQ(v.footprintError.error.rms, 0.5);
        EXPECT_EQ(v.footprintError.error.p999, 0.5);
        EXPECT_EQ(v.footprintError.error.standardError, 0.0);
        EXPECT_EQ(v.meanAbsoluteError, 0.5);
    }
}

/// For a binary technique, both kinds of counting say the same.
TEST(FootprintError, IsTheShareOfWrongSamplesOfABinaryTechnique) {
    const std::unique_ptr<Technique> tsm = makeTechnique("tsm", sharedRenderer().programs());
    const Verification v = verifyFrame(sharedRenderer(), thePlan(), *tsm, allSamples());
    EXPECT_GT(v.disagree(), 50u);
    EXPECT_DOUBLE_EQ(v.footprintError.error.mean, 1e-6 * v.ppm());
    EXPECT_DOUBLE_EQ(v.footprintError.error.meanSquare, 1e-6 * v.ppm());
    EXPECT_EQ(v.footprintError.error.p999, 1.0);
}

TEST(FootprintError, TakesAboutAsManySamplesAsItIsTold) {
    GivenVisibilityTechnique exact = meansOf(over(Footprint::Time::Stratum), 17, 18);
    VerificationOptions options = allSamples();
    options.footprint.samples = 700;
    const Verification v = verifyFrame(sharedRenderer(), thePlan(), exact, options);
    // Of all camera samples, those that are tested; a binomial number, within four deviations.
    const double expected = 700.0 * static_cast<double>(v.tested) / static_cast<double>(v.samples);
    EXPECT_NEAR(static_cast<double>(v.footprintError.error.count), expected, 4.0 * std::sqrt(expected));
    options.footprint.samples = 0;
    EXPECT_EQ(verifyFrame(sharedRenderer(), thePlan(), exact, options).footprintError.error.count, 0u);
}

std::shared_ptr<const ReferenceVisibility> converged(const FramePlan& plan) {
    return referenceVisibility(plan, 1024, ReferenceCache(std::filesystem::path()));
}

std::shared_ptr<const ReferenceVisibility> theReference() {
    static const std::shared_ptr<const ReferenceVisibility> reference = converged(thePlan());
    return reference;
}

VerificationOptions withReference() {
    VerificationOptions options = allSamples();
    options.reference = theReference();
    return options;
}

bool anyTested(const std::vector<OracleAnswer>& answers, std::size_t pixel) {
    for (std::size_t k = 0; k < strata; ++k)
        if (answers[k * width * height + pixel].tested) return true;
    return false;
}

/// Every sample of a pixel has the pixel's converged mean, by other rays than the reference.
void expectNoShadowErrorOfTheConvergedMean(const FramePlan& frame) {
    const std::shared_ptr<const ReferenceVisibility> reference = converged(frame);
    Halves halves;
    GivenVisibilityTechnique converged(
        over(Footprint::Time::Shutter, Footprint::Space::PixelSurface),
        [&](const Oracle& oracle, const FramePlan& plan, const std::vector<std::uint32_t>& ids) {
            const std::vector<VisibilityMean> a = oracle.pixelMeans(plan, 0, height, 512, 21),
                                              b = oracle.pixelMeans(plan, 0, height, 512, 22);
            const std::vector<OracleAnswer> answers = oracle.answer(plan, ids);
            std::vector<float> means(a.size(), 0.0f), lit;
            for (std::size_t i = 0; i < means.size(); ++i)
                if (anyTested(answers, i) && reference->has(i)) means[i] = halves.mean(i, a[i], b[i]);
            for (int k = 0; k < strata; ++k) lit.insert(lit.end(), means.begin(), means.end());
            return lit;
        });
    VerificationOptions options = allSamples();
    options.reference = reference;
    const Verification v = verifyFrame(sharedRenderer(), frame, converged, options);
    ASSERT_TRUE(v.shadowError);
    const ErrorSummary& e = v.shadowError->error;
    EXPECT_EQ(v.shadowError->rays, 1024);
    EXPECT_GT(e.count, 1000u);
    // The double's own noise, known by its halves, is all that is left: 3e-5 or so.
    halves.expectNoiseAlone(e);
    EXPECT_LT(e.meanSquare, 1e-4);
    EXPECT_LT(e.mean, 0.01) << "not debiased, but 1,024 rays are not far off";
}

TEST(ShadowError, OfTheConvergedMeanIsNothing) {
    for (const FramePlan& plan : thePlans()) expectNoShadowErrorOfTheConvergedMean(plan);
}

TEST(ShadowError, OfTheReferencesHalvesIsZeroOnAverage) {
    // The first half as the technique: its product with the second half's difference is 0 in each pixel.
    GivenVisibilityTechnique half({}, [](const Oracle&, const FramePlan&, const std::vector<std::uint32_t>& ids) {
        std::vector<float> lit(ids.size());
        for (std::size_t i = 0; i < lit.size(); ++i)
            lit[i] = std::max(0.0f, theReference()->first[i % (width * height)]);
        return lit;
    });
    const Verification v = verifyFrame(sharedRenderer(), thePlan(), half, withReference());
    EXPECT_NEAR(v.shadowError->error.meanSquare, 0.0, 1e-15);
    EXPECT_GT(v.shadowError->error.mean, 1e-4);
}

TEST(ShadowError, OfAHalfIsComputedByHand) {
    GivenVisibilityTechnique half(
        {}, [](const Oracle&, const FramePlan&, const auto& ids) { return std::vector<float>(ids.size(), 0.5f); });
    const Verification v = verifyFrame(sharedRenderer(), thePlan(), half, withReference());
    const Oracle oracle(thePlan());
    const std::vector<OracleAnswer> answers = oracle.answer(thePlan(), oracle.tracePrimaries(thePlan()));
    const ReferenceVisibility& reference = *theReference();
    double sum = 0.0, squares = 0.0;
    std::size_t count = 0, without = 0;
    for (std::size_t pixel = 0; pixel < reference.first.size(); ++pixel) {
        if (!reference.has(pixel)) continue;
        if (!anyTested(answers, pixel)) {
            ++without;
            continue;
        }
        const double a = static_cast<double>(reference.first[pixel]), b = static_cast<double>(reference.second[pixel]);
        sum += std::abs(0.5 - 0.5 * (a + b));
        squares += (0.5 - a) * (0.5 - b);
        ++count;
    }
    const ShadowError& e = *v.shadowError;
    EXPECT_EQ(e.error.count, count);
    EXPECT_EQ(e.pixelsWithoutSamples, without);
    EXPECT_GT(without, 0u);
    EXPECT_NEAR(e.error.mean, sum / static_cast<double>(count), 1e-12);
    EXPECT_NEAR(e.error.rms, std::sqrt(squares / static_cast<double>(count)), 1e-12);
}

/// Brute force with many renders is right but for its map: its pixels' means are over all renders.
TEST(ShadowError, TakesAllRendersOfAFrame) {
    const auto errorOf = [](const char* renders) {
        const std::unique_ptr<Technique> accumulation = makeTechnique("accumulation", sharedRenderer().programs());
        setFromText(*accumulation, "renders", renders);
        return verifyFrame(sharedRenderer(), thePlan(), *accumulation, withReference()).shadowError->error.rms;
    };
    const double few = errorOf("4"), many = errorOf("32");
    EXPECT_GT(few, 0.05);
    EXPECT_LT(many, 0.6 * few);
}

TEST(ReferenceVisibility, ComesOutOfTheCacheAsItWentIn) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("timeshade-visibility-" + std::to_string(getpid()));
    const ReferenceCache cache(folder);
    int steps = 0;
    const auto count = [&](int, int) { ++steps; };
    const auto computed = referenceVisibility(thePlan(), 30, cache, count);
    EXPECT_EQ(computed->rays, 32) << "whole packets of both halves";
    EXPECT_GT(steps, 1);
    steps = 0;
    const auto cached = referenceVisibility(thePlan(), 32, cache, count);
    EXPECT_EQ(steps, 0) << "computed again";
    EXPECT_EQ(computed->first, cached->first);
    EXPECT_EQ(computed->second, cached->second);
    FramePlan other = thePlan();
    other.block.seed = 1234;
    other.block.strata = 2;
    EXPECT_EQ(referenceVisibilityKey(other, 32), referenceVisibilityKey(thePlan(), 32));
    other.lightClose.position.x += 0.1;
    EXPECT_NE(referenceVisibilityKey(other, 32), referenceVisibilityKey(thePlan(), 32));
    EXPECT_NE(referenceVisibilityKey(thePlan(), 64), referenceVisibilityKey(thePlan(), 32));
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace timeshade
