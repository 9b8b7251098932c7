// The epipolar view: what each technique says that it stored along a line of the light's map, against what is there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measure/epipolar_picture.h"
#include "measure/epipolar_view.h"
#include "scene_catalogue.h"
#include "support/gl_environment.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

constexpr int mapSide = 256;

/// Two quads that pass across each other, and the ground.
const FramePlan& crossingPlan() {
    static const std::unique_ptr<Scene> scene = openScene("crossing", "");
    static const FramePlan plan = [] {
        FrameRequest request;
        request.width = 64;
        request.height = 48;
        request.samplesPerPixel = 4;
        request.mapSize = mapSide;
        request.frame = scene->defaults().frame;
        request.shutter = {scene->defaults().framesPerSecond, scene->defaults().shutterLength, ShutterPosition::Start};
        return FramePlanner(*scene).plan(request);
    }();
    return plan;
}

const Oracle& crossingOracle() {
    static const Oracle oracle(crossingPlan());
    return oracle;
}

/// Through the centres of a row of texels, where both quads pass.
MapLine middleRow() {
    const double centre = (mapSide / 2 + 0.5) / mapSide;
    return {{0.3, centre}, {0.7, centre}};
}

EpipolarView viewOf(const std::string& name, const std::string& settings = {},
                    std::optional<glm::uvec2> pixel = std::nullopt, const MapLine& line = middleRow()) {
    const std::unique_ptr<Technique> technique = makeTechnique(name, sharedRenderer().programs());
    if (const std::size_t is = settings.find('='); is != std::string::npos)
        setFromText(*technique, settings.substr(0, is), settings.substr(is + 1));
    return epipolarView(sharedRenderer(), crossingOracle(), crossingPlan(), *technique, line, pixel);
}

/// The share of the cells in rows [first, last) whose stored distance is not the true one to a hundredth.
double wrongShare(const EpipolarView& view, std::uint32_t first, std::uint32_t last) {
    const std::vector<double> stored = nearestStored(view);
    std::size_t wrong = 0;
    for (std::size_t i = std::size_t{first} * view.columns; i < std::size_t{last} * view.columns; ++i) {
        const bool seen = view.truth[i].triangle != NO_TRIANGLE;
        const bool right =
            seen ? std::abs(stored[i] - view.truth[i].depth) <= 0.01 * view.truth[i].depth : !std::isfinite(stored[i]);
        wrong += right ? 0 : 1;
    }
    return static_cast<double>(wrong) / static_cast<double>((last - first) * view.columns);
}
double deepestOf(const EpipolarView& view) {
    double deepest = 0.0;
    for (const StoredMark& mark : view.stored.marks) deepest = std::max(deepest, mark.depthFrom);
    return deepest;
}
double wrongShare(const EpipolarView& view) { return wrongShare(view, 0, view.rows); }

TEST(Epipolar, EveryTechniqueGivesAPictureTheSameEveryTime) {
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        const std::string& name = description.name;
        SCOPED_TRACE(name);
        const EpipolarView view = viewOf(name), again = viewOf(name);
        EXPECT_EQ(view.stored.marks, again.stored.marks);
        for (const StoredMark& mark : view.stored.marks) {
            ASSERT_TRUE(0.0 <= mark.xFrom && mark.xFrom < mark.xTo && mark.xTo <= 1.0);
            ASSERT_TRUE(mark.uFrom <= mark.uTo && mark.opacity > 0.0 && mark.opacity <= 1.0);
            ASSERT_TRUE(std::isfinite(mark.depthFrom) && std::isfinite(mark.depthTo) && mark.depthFrom > 0.0);
        }
        const DisplayImage picture = drawEpipolarView(view, description.title);
        EXPECT_EQ(picture.rgb.size(), static_cast<std::size_t>(picture.width * picture.height * 3));
    }
}

/// A texel stands for its width: of 102 texels along the line the quads' four borders cut two each, half of it wrong.
TEST(Epipolar, ListsOfIntervalsAreTheTruthToTheTexel) {
    EXPECT_LT(wrongShare(viewOf("temporal")), 0.03);
    EXPECT_LT(wrongShare(viewOf("temporal", "as_published=on")), 0.03);
    EXPECT_LT(wrongShare(viewOf("ranges", "as_published=on")), 0.03);
    EXPECT_LT(wrongShare(viewOf("accumulation", "renders=64")), 0.03);
}

/// Extended inside a texel, they are finer than it.
TEST(Epipolar, ExtendedRangesAreFinerThanATexel) {
    EXPECT_LT(wrongShare(viewOf("ranges")), 0.5 * wrongShare(viewOf("temporal")));
}

TEST(Epipolar, AnOrdinaryMapIsTheTruthOfOneInstant) {
    const EpipolarView view = viewOf("static");
    EXPECT_LT(wrongShare(view, view.rows / 2 - 1, view.rows / 2 + 1), 0.03);
    EXPECT_GT(wrongShare(view), 0.1);
}

/// Of a technique that stores texels at times of their own: how many in each of the four strata.
std::vector<int> pointsOf(const std::string& name) {
    const EpipolarView view = viewOf(name);
    std::size_t points = 0, wrong = 0;
    std::vector<int> inStratum(4, 0);
    for (const StoredMark& mark : view.stored.marks) {
        if (mark.uFrom < mark.uTo) continue;
        ++points;
        ++inStratum.at(static_cast<std::size_t>(std::min(3.0, 4.0 * mark.uFrom)));
        // The ends of the line lie inside a texel, whose centre is what is stored.
        const glm::dvec2 place = view.line.at(0.5 * (mark.xFrom + mark.xTo));
        const glm::dvec2 centre = (glm::floor(place * double{mapSide}) + 0.5) / double{mapSide};
        const SeenByLight seen = crossingOracle().seenByLight(crossingPlan(), centre, mark.uFrom);
        wrong += std::abs(seen.depth - mark.depthFrom) > 1e-4 * seen.depth ? 1 : 0;
    }
    EXPECT_GT(points, 100u);
    EXPECT_LE(wrong, 2u) << "of " << points << "; rounding at an edge";
    return inStratum;
}

TEST(Epipolar, PointsAreWhatTheLightSeesThereAndThen) {
    for (const char* name : {"tsm", "interleaved"}) {
        SCOPED_TRACE(name);
        for (const int count : pointsOf(name)) EXPECT_GT(count, 10) << "every stratum has a layer";
    }
}

/// The quads translate: layers that move with them are the truth but for the border's cells, which are stretched to a
/// few texels and partly transparent. Distances are means over the samples of a cell.
TEST(Epipolar, LayersMoveAsTheirCastersDo) {
    EXPECT_LT(wrongShare(viewOf("layers")), 0.15);
    EXPECT_LT(wrongShare(viewOf("layers")), 0.5 * wrongShare(viewOf("static")));
    EXPECT_GT(wrongShare(viewOf("layers", "count=1")), wrongShare(viewOf("layers")));
}

/// A visibility function has no time: what moves is as opaque throughout as it is long there.
TEST(Epipolar, DeepMapsHoldTheShareOfTheShutter) {
    const EpipolarView view = viewOf("deep", "error=0.001");
    std::size_t tested = 0;
    for (std::uint32_t column = 0; column < view.columns; column += 7) {
        double covered = 0.0, left = 1.0;
        for (std::uint32_t row = 0; row < view.rows; ++row) {
            const std::uint32_t seen = view.truth[std::size_t{row} * view.columns + column].triangle;
            covered += seen != NO_TRIANGLE && view.instances[seen] != 0 ? 1.0 / view.rows : 0.0;
        }
        const double x = (column + 0.5) / view.columns;
        for (const StoredMark& mark : view.stored.marks) {
            EXPECT_EQ(mark.uTo - mark.uFrom, 1.0);
            // The ground is in the map of what stands still, opaque and farthest.
            if (mark.xFrom <= x && x < mark.xTo && mark.depthFrom < 0.99 * deepestOf(view)) left *= 1.0 - mark.opacity;
        }
        EXPECT_NEAR(1.0 - left, covered, 0.06) << "the nearest texel's centre, and 128 times";
        tested += covered > 0.0 ? 1 : 0;
    }
    EXPECT_GT(tested, 10u);
}

/// Candidates are never farther than what they stand for, wherever something shadows something.
TEST(Epipolar, CandidatesCoverTheTruth) {
    const EpipolarView view = viewOf("exact");
    const std::vector<double> stored = nearestStored(view);
    std::size_t quads = 0;
    double nearest = 1e30;
    for (std::size_t i = 0; i < view.truth.size(); ++i) {
        const std::uint32_t triangle = view.truth[i].triangle;
        if (triangle == NO_TRIANGLE || view.instances[triangle] == 0) continue;  // the ground shadows nothing
        ++quads;
        ASSERT_LE(stored[i], view.truth[i].depth * (1.0 + 1e-6));
        nearest = std::min(nearest, view.truth[i].depth);
    }
    EXPECT_GT(quads, 1000u);
    // A bound is of a whole triangle, whose nearest corner may lie beside the line.
    for (const double depth : stored) ASSERT_GT(depth, 0.9 * nearest) << "far nearer than anything";
}

TEST(Epipolar, FollowsAPixelsReceivers) {
    const FramePlan& plan = crossingPlan();
    std::size_t shown = 0, shadowed = 0;
    for (std::uint32_t x = 20; x < 48; x += 3) {
        const glm::uvec2 pixel(x, 18);
        const std::optional<MapLine> line = lineThroughPixel(crossingOracle(), plan, pixel);
        ASSERT_TRUE(line);
        const EpipolarView view = viewOf("exact", "", pixel, *line);
        ASSERT_FALSE(view.samples.empty());
        EXPECT_LT(view.samples.front().texelsOff, 1e-6) << "the line runs through the first";
        for (const EpipolarSample& sample : view.samples) {
            ++shown;
            EXPECT_EQ(sample.uFrom, sample.uTo) << "an instant";
            EXPECT_EQ(sample.path.size(), 65u);
            if (!sample.tested) continue;
            EXPECT_EQ(sample.lit, sample.truth ? 1.0 : 0.0);
            shadowed += sample.truth ? 0 : 1;
            if (sample.texelsOff > 1e-6) continue;
            // By the picture itself: the cell that holds the sample is nearer to the light than the receiver, or not.
            const auto column = static_cast<std::size_t>(sample.place.x * view.columns);
            const auto row = static_cast<std::size_t>(sample.place.u * view.rows);
            const double nearest = view.truth[row * view.columns + column].depth;
            EXPECT_EQ(nearest < 0.99 * sample.place.depth, !sample.truth) << "pixel " << x;
        }
    }
    EXPECT_GT(shown, 30u);
    EXPECT_GT(shadowed, 5u);
    EXPECT_LT(shadowed, shown);
    EXPECT_FALSE(lineThroughPixel(crossingOracle(), plan, {0, 47})) << "no sample there is inside the shadow map";
}

/// Each render has a sample of its own.
TEST(Epipolar, HasASampleOfEveryRender) {
    const EpipolarView view = viewOf("accumulation", "renders=8", glm::uvec2(32, 18));
    ASSERT_EQ(view.samples.size(), 8u);
    for (std::size_t m = 0; m < 8; ++m)
        EXPECT_NEAR(view.samples[m].place.u, (static_cast<double>(m) + 0.5) / 8.0, 1e-6);
}

}  // namespace
}  // namespace timeshade
