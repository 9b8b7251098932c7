// Every registered technique on scenes whose lit share is known exactly: the mean over many samples must agree within
// what sampling theory and the map's resolution allow, and where a technique must fail, it must fail by as much as
// theory says.

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "cases/closed_form_cases.h"
#include "cases/expectation.h"
#include "measure/case_matrix.h"
#include "support/gl_environment.h"
#include "support/thorough.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

constexpr int width = 12, height = 384;

struct Measurement {
    double mean = 0.0;
    std::vector<double> pixels;  ///< mean over each pixel's samples
};

Measurement measure(Scene& scene, Technique& technique, int samplesPerPixel, int mapSize, std::uint32_t seed) {
    FrameRenderer& renderer = sharedRenderer();
    FramePlanner planner(scene);
    renderer.draw(planner.plan(ProceduralScene::request(width, height, samplesPerPixel, mapSize, seed)), technique,
                  View::Visibility);
    Measurement m;
    const LinearImage image = renderer.readRadiance();
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) m.pixels.push_back(static_cast<double>(image.rgb[i]));
    m.mean = std::accumulate(m.pixels.begin(), m.pixels.end(), 0.0) / static_cast<double>(m.pixels.size());
    return m;
}

/// Time and space are sampled at random: four standard errors of the mean. TSM's texels are shared by the pixels that
/// see them, so the independent samples are those of the map column that the picture covers, one per texel and stratum.
double samplingTolerance(double share, int strata, double independentColumns) {
    return 4.0 * std::sqrt(share * (1.0 - share) / (strata * independentColumns));
}

/// Share of the shutter by which half a texel of the map at the caster's depth moves the shadow's two ends in case 1.
double mapTolerance(int mapSize) { return 5.0 * 2.0 * std::tan(0.62) / mapSize / 2.5; }

double rootMeanSquare(const std::vector<double>& values, double exact) {
    double sum = 0.0;
    for (const double value : values) sum += (value - exact) * (value - exact);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Slope of log(error) over log(sample count), by least squares.
double slope(const std::vector<double>& sampleCount, const std::vector<double>& error) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    const auto n = static_cast<double>(sampleCount.size());
    for (std::size_t i = 0; i < sampleCount.size(); ++i) {
        const double x = std::log(sampleCount[i]), y = std::log(error[i]);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

using Parameters = std::tuple<std::string, std::string>;
/// Of a technique, or of its published form: "tsm", "ranges as_published".
class ClosedForm : public testing::TestWithParam<Parameters> {};

constexpr const char* asPublished = "as_published";

bool hasPublishedForm(Technique& technique) {
    const std::vector<Setting> settings = settingsOf(technique);
    return std::any_of(settings.begin(), settings.end(), [](const Setting& s) { return s.key == asPublished; });
}

std::unique_ptr<Technique> techniqueOf(const std::string& form) {
    const std::string name = form.substr(0, form.find(' '));
    std::unique_ptr<Technique> technique = makeTechnique(name, sharedRenderer().programs());
    if (form != name) setFromText(*technique, asPublished, "on");
    return technique;
}

TEST_P(ClosedForm, RightOrOffAsItStates) {
    const auto& [form, caseName] = GetParam();
    const ClosedFormCase& c = closedFormCase(caseName);
    const std::unique_ptr<Technique> technique = techniqueOf(form);
    const std::string techniqueName = technique->description().name;
    if (techniqueName == "accumulation") setFromText(*technique, "renders", "64");
    // A focused map's texels are smaller than the expectation assumes.
    if (techniqueName == "history") setFromText(*technique, "fit", "0");
    // Grids for every tile of the map take a second a picture at 512.
    const int map = techniqueName != "layers" ? 512 : testedShare() == TestedShare::All ? 256 : 128;
    const CaseResult r = runCase(sharedRenderer(), *technique, c, {8, map});
    if (r.verdict == Verdict::NotTaken) GTEST_SKIP() << r.reason;
    EXPECT_NE(r.verdict, Verdict::Wrong) << r.value << " measured, " << r.exact << " (tolerance " << r.tolerance
                                         << ") is right, " << r.predicted << " (tolerance " << r.predictedTolerance
                                         << ") is what follows from what the technique states";
}

std::vector<std::string> forms() {
    gl::ProgramCache programs;
    std::vector<std::string> names;
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        names.push_back(description.name);
        if (hasPublishedForm(*makeTechnique(description.name, programs)))
            names.push_back(description.name + " " + asPublished);
    }
    return names;
}

/// All forms in all cases that are pictures; as a rule every seventh of them, each form in others than the one before.
std::vector<Parameters> formsInCases() {
    std::vector<Parameters> all;
    std::size_t formNumber = 0;
    for (const std::string& form : forms()) {
        std::size_t number = formNumber++;
        for (const ClosedFormCase& c : closedFormCases())
            if (c.kind == ClosedFormCase::Kind::Picture && isDrawn(number++, 7)) all.emplace_back(form, c.name);
    }
    return all;
}

INSTANTIATE_TEST_SUITE_P(AllTechniques, ClosedForm, testing::ValuesIn(formsInCases()),
                         [](const testing::TestParamInfo<Parameters>& test) {
                             std::string name = std::get<0>(test.param) + "_" + std::get<1>(test.param);
                             std::replace(name.begin(), name.end(), ' ', '_');
                             return name;
                         });

class SmallestGap : public testing::TestWithParam<std::string> {};

TEST_P(SmallestGap, IsThatOfTheTechniquesBias) {
    const CaseResult r = runContactGaps(sharedRenderer(), *techniqueOf(GetParam()), {8, 512});
    ASSERT_NE(r.verdict, Verdict::NotTaken) << r.reason;
    EXPECT_NE(r.verdict, Verdict::Wrong) << r.value << " measured, " << r.predicted << " follows from the bias";
}

INSTANTIATE_TEST_SUITE_P(AllTechniques, SmallestGap, testing::ValuesIn(forms()),
                         [](const testing::TestParamInfo<std::string>& test) {
                             std::string name = test.param;
                             std::replace(name.begin(), name.end(), ' ', '_');
                             return name;
                         });

/// TSM's lit value is random in a stratum that a shadow's end splits into f and 1 - f: the variance of a pixel is the
/// sum of f (1 - f) over the ends, divided by N^2. The error therefore falls with slope -1, and can be predicted.
TEST(Convergence, TsmFollowsStratifiedSampling) {
    const ClosedFormCase& c = closedFormCase("quad_sweeps_point");
    const std::unique_ptr<Technique> technique = makeTechnique("tsm", sharedRenderer().programs());
    std::vector<double> sampleCount, error;
    for (const int strata : {2, 4, 8, 16, 32}) {
        std::vector<double> pixels;
        for (std::uint32_t seed = 1; seed <= 4; ++seed) {
            const Measurement m = measure(*c.scene, *technique, strata, 1024, seed);
            pixels.insert(pixels.end(), m.pixels.begin(), m.pixels.end());
        }
        double variance = 0.0;
        for (const double end : {0.3, 0.7}) {
            const double f = end * strata - std::floor(end * strata);
            variance += f * (1.0 - f);
        }
        sampleCount.push_back(strata);
        error.push_back(rootMeanSquare(pixels, c.exact));
        // The caster's time is random within the stratum and so decides; the map's half texel widens it a little.
        EXPECT_NEAR(error.back(), std::sqrt(variance) / strata,
                    0.12 * std::sqrt(variance) / strata + mapTolerance(1024))
            << strata << " strata";
    }
    EXPECT_NEAR(slope(sampleCount, error), -1.0, 0.12);
}

/// Accumulation draws M evenly spaced instants: each end of an interval is off by at most 1 / (2M), slope -1.
TEST(Convergence, AccumulationFallsAsOneOverRenders) {
    const std::unique_ptr<Technique> technique = makeTechnique("accumulation", sharedRenderer().programs());
    std::vector<double> sampleCount, error;
    for (const int renders : {4, 8, 16, 32, 64}) {
        setFromText(*technique, "renders", std::to_string(renders));
        std::vector<double> means;
        // Shifts that no power of two divides, so that the ends fall anywhere between two instants.
        for (int i = 0; i < 7; ++i)
            means.push_back(measure(*sweptPointScene(-0.43 + 0.137 * i), *technique, 1, 1024, 1).mean);
        sampleCount.push_back(renders);
        error.push_back(rootMeanSquare(means, 0.6));
        for (const double mean : means) EXPECT_NEAR(mean, 0.6, 1.0 / renders + mapTolerance(1024));
    }
    EXPECT_NEAR(slope(sampleCount, error), -1.0, 0.35);
}

/// N P^2 fixed times: each end of an interval is off by at most half of the time between two, slope -1.
TEST(Convergence, InterleavedFallsAsOneOverItsTimes) {
    const std::unique_ptr<Technique> technique = makeTechnique("interleaved", sharedRenderer().programs());
    std::vector<double> sampleCount, error;
    for (const auto& [strata, side] : {std::pair{1, 2}, {2, 2}, {1, 4}, {4, 2}, {2, 4}, {8, 2}}) {
        setFromText(*technique, "pattern", std::to_string(side));
        std::vector<double> means;
        // Shifts that no power of two divides, so that the ends fall anywhere between two times.
        for (int i = 0; i < 7; ++i)
            means.push_back(measure(*sweptPointScene(-0.43 + 0.137 * i), *technique, strata, 2048, 1).mean);
        sampleCount.push_back(strata * side * side);
        error.push_back(rootMeanSquare(means, 0.6));
        for (const double mean : means)
            EXPECT_NEAR(mean, 0.6, 1.0 / sampleCount.back() + side * mapTolerance(2048)) << strata << ", " << side;
    }
    EXPECT_NEAR(slope(sampleCount, error), -1.0, 0.35);
}

/// Case 9 with a bias: a receiver that approaches the light by v per shutter is in its own shadow on
/// 1/2 (1 - b N / v)^2 of the samples, b being the bias in world units; none where b N >= v.
TEST(PredictedFailure, TsmSelfShadowFollowsItsFormula) {
    const ClosedFormCase& c = closedFormCase("approaching_self");
    const std::unique_ptr<Technique> technique = makeTechnique("tsm", sharedRenderer().programs());
    const double speed = 8.0;
    for (const int strata : {4, 16}) {
        for (const char* bias : {"0", "8", "32"}) {
            setFromText(*technique, "bias", bias);
            double shadow = 0.0;
            for (int k = 0; k < strata; ++k) {
                const double distance = 9.0 - speed * (k + 0.5) / strata;  // from the light, mid-stratum
                const double world = std::stod(bias) * distance * 2.0 * std::tan(0.62) / 1024.0;
                const double free = std::max(0.0, 1.0 - world * strata / speed);
                shadow += 0.5 * free * free / strata;
            }
            const Measurement m = measure(*c.scene, *technique, strata, 1024, 3);
            // Independent texels: the receiver is 0.7 tall, and at its farthest covers the fewest.
            const double columns = 0.7 / (9.0 * 2.0 * std::tan(0.62)) * 1024;
            EXPECT_NEAR(m.mean, 1.0 - shadow, samplingTolerance(0.5, strata, columns) + 0.01)
                << strata << " strata, bias " << bias;
        }
    }
}

/// Of a plane nothing shadows itself where and when a texel looks, whatever the bias.
TEST(PredictedFailure, ThePlaneTestEndsTheSelfShadow) {
    const ClosedFormCase& c = closedFormCase("approaching_self");
    for (const char* name : {"tsm", "interleaved"}) {
        const std::unique_ptr<Technique> technique = makeTechnique(name, sharedRenderer().programs());
        setFromText(*technique, "plane_test", "on");
        setFromText(*technique, "bias", "0.1");
        EXPECT_NEAR(measure(*c.scene, *technique, 8, 1024, 3).mean, 1.0, 1e-6) << name;
    }
}

/// Equation 12 of Andersson et al. 2015 moves the map's depth to the receiver's time: no self-shadowing is left.
TEST(PredictedFailure, DynamicBiasEndsTheSelfShadow) {
    const ClosedFormCase& c = closedFormCase("approaching_self");
    const std::unique_ptr<Technique> technique = makeTechnique("tsm", sharedRenderer().programs());
    setFromText(*technique, "dynamic_bias", "on");
    EXPECT_NEAR(measure(*c.scene, *technique, 8, 1024, 3).mean, 1.0, 1e-6);
    // And casts a real shadow as before.
    const ClosedFormCase& swept = closedFormCase("quad_sweeps_point");
    EXPECT_NEAR(measure(*swept.scene, *technique, 8, 1024, 3).mean, 0.6, 0.02);
}

}  // namespace

}  // namespace timeshade
