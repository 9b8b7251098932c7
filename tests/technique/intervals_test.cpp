// Interval shadow maps: what they promise beside what holds for every technique.
#include "techniques/intervals/intervals_shadow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "scene_catalogue.h"
#include "support/gl_environment.h"
#include "support/moving_scene.h"

namespace timeshade {
namespace {

constexpr double nothing = 1e9;
constexpr int mapSide = 128;

/// Quads that are not flat, and move and turn.
const ProceduralScene& movingScene() {
    static const std::unique_ptr<ProceduralScene> scene = makeMovingScene({.quads = 60, .seed = 7});
    return *scene;
}

FrameRequest movingRequest() { return ProceduralScene::request(64, 48, 4, mapSide, 3); }

using Settings = std::vector<std::pair<std::string, std::string>>;

void set(Technique& technique, const Settings& settings) {
    for (const auto& [key, value] : settings) setFromText(technique, key, value);
}

std::vector<float> visibilityOf(Technique& technique, const Settings& settings) {
    resetSettings(technique);
    set(technique, settings);
    sharedRenderer().draw(FramePlanner(movingScene()).plan(movingRequest()), technique, View::Visibility);
    return sharedRenderer().readVisibility();
}

double statistic(const Technique& technique, const std::string& name) {
    for (const TechniqueStatistic& each : technique.statistics())
        if (each.name == name) return each.value;
    ADD_FAILURE() << "no statistic " << name;
    return 0.0;
}

double meanOf(const std::vector<float>& values) {
    double sum = 0.0;
    for (const float value : values) sum += static_cast<double>(value);
    return sum / static_cast<double>(values.size());
}

std::size_t differences(const std::vector<float>& a, const std::vector<float>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1u : 0u;
    return count;
}

struct Hit {
    double depth = nothing;
    double edge = nothing;  ///< least share of any triangle's barycentric coordinates by which the line misses an edge
};

/// The nearest triangle on a line of sight of the light at time u, in double precision, one by one.
Hit nearestInTruth(const FramePlan& plan, const glm::dvec2& place, double u) {
    const LightRay ray = lightRayThrough(plan, place, u);
    Hit hit;
    for (const glm::u32vec3& t : plan.mesh->topology->triangles) {
        glm::dvec3 p[3];
        for (int i = 0; i < 3; ++i)
            p[i] =
                glm::mix(glm::dvec3(plan.mesh->positionsOpen[t[i]]), glm::dvec3(plan.mesh->positionsClose[t[i]]), u) -
                plan.origin - ray.from;
        glm::dvec3 e;
        for (int i = 0; i < 3; ++i) e[i] = glm::dot(ray.direction, glm::cross(p[(i + 1) % 3], p[(i + 2) % 3]));
        const double sum = e.x + e.y + e.z;
        const glm::dvec3 weights = e / sum;
        const double least = std::min({weights.x, weights.y, weights.z});
        hit.edge = std::min(hit.edge, std::abs(least));
        if (!(least >= 0.0)) continue;
        const glm::dvec3 at = weights.x * p[0] + weights.y * p[1] + weights.z * p[2];
        const double depth = glm::dot(at, ray.direction) / glm::dot(ray.direction, ray.direction);
        if (depth > 0.0) hit.depth = std::min(hit.depth, depth);
    }
    return hit;
}

double nearestOf(const std::vector<StoredMark>& marks, double x, double u) {
    double nearest = nothing;
    for (const StoredMark& m : marks) {
        if (x < m.xFrom || x > m.xTo || u < m.uFrom || u > m.uTo) continue;
        const double share = m.uTo > m.uFrom ? (u - m.uFrom) / (m.uTo - m.uFrom) : 0.0;
        nearest = std::min(nearest, glm::mix(m.depthFrom, m.depthTo, share));
    }
    return nearest;
}

struct Comparison {
    std::size_t instants = 0, wrong = 0;
    double most = 0.0;  ///< error of a distance, texels
};

/// What lists say of texels of some rows of the map, against what the light sees through their centres.
Comparison compareLists(const Settings& settings) {
    IntervalsShadow technique(sharedRenderer().programs());
    set(technique, settings);
    const FramePlan plan = FramePlanner(movingScene()).plan(movingRequest());
    sharedRenderer().draw(plan, technique, View::Visibility);
    Comparison found;
    for (int row = 3; row < mapSide; row += 17) {
        const double y = (row + 0.5) / mapSide;
        const MapLine line{{0.0, y}, {1.0, y}};
        const std::vector<StoredMark> marks = sharedRenderer().storedAlong(line).marks;
        for (int column = 1; column < mapSide; column += 3)
            for (int k = 0; k < 23; ++k) {
                const double u = (k + 0.37) / 23, x = (column + 0.5) / mapSide;
                const Hit truth = nearestInTruth(plan, {x, y}, u);
                if (truth.edge < 1e-4) continue;
                ++found.instants;
                const double is = nearestOf(marks, x, u);
                if ((is == nothing) != (truth.depth == nothing)) {
                    ++found.wrong;
                } else if (is != nothing) {
                    const double texel = static_cast<double>(plan.block.lightCone.w) * truth.depth;
                    found.most = std::max(found.most, std::abs(is - truth.depth) / texel);
                }
            }
    }
    return found;
}

/// Rounding may take one of two triangles that cross for the nearer where they are within their bounds: then both are.
TEST(Intervals, ListsHoldWhatTheLightSees) {
    for (const char* bound : {"0.5", "0.125", "0.02"}) {
        const Comparison found = compareLists({{"depth_error", bound}});
        EXPECT_GT(found.instants, 5000u);
        EXPECT_EQ(found.wrong, 0u);
        EXPECT_LE(found.most, 1.3 * std::stod(bound)) << "of " << bound;
    }
    EXPECT_GT(compareLists({{"depth_error", "16"}}).most, 0.5) << "nothing bends, so the test shows nothing";
}

TEST(Intervals, ListsAsPublishedHoldEverything) {
    const Comparison one = compareLists({{"as_published", "on"}, {"capacity", "none"}}),
                     four = compareLists({{"as_published", "on"}, {"capacity", "none"}, {"depth_pieces", "4"}});
    EXPECT_EQ(one.wrong, 0u);
    EXPECT_EQ(four.wrong, 0u);
    EXPECT_LT(four.most, 0.3 * one.most) << "figure 2.6: four linear parts";
}

TEST(Intervals, LeavingOutWhatIsHiddenChangesNoPicture) {
    IntervalsShadow technique(sharedRenderer().programs());
    const std::vector<float> all = visibilityOf(technique, {{"visible_only", "off"}});
    const double before = statistic(technique, "intervals");
    const std::vector<float> visible = visibilityOf(technique, {});
    EXPECT_EQ(differences(all, visible), 0u);
    EXPECT_LT(statistic(technique, "intervals"), 0.95 * before);
    EXPECT_LT(statistic(technique, "bent intervals"), 1e-3 * before) << "of triangles that are seen all but edge-on";
    EXPECT_EQ(statistic(technique, "intervals collected"), before);
}

/// Where nothing is merged, capacity changes nothing; where something is, the error is counted.
TEST(Intervals, CapacityCostsWhatItCounts) {
    IntervalsShadow technique(sharedRenderer().programs());
    const std::vector<float> whole = visibilityOf(technique, {{"as_published", "on"}, {"capacity", "none"}});
    EXPECT_EQ(statistic(technique, "overflowed texels"), 0.0);
    EXPECT_EQ(statistic(technique, "compression error"), 0.0);
    const double most = statistic(technique, "most intervals");
    ASSERT_GT(most, 8.0) << "nothing overflows, so the test shows nothing";
    std::size_t last = whole.size();
    double lastTexels = 1e9;
    for (const char* capacity : {"8", "16", "32"}) {
        const std::size_t changed =
            differences(whole, visibilityOf(technique, {{"as_published", "on"}, {"capacity", capacity}}));
        const double texels = statistic(technique, "overflowed texels");
        EXPECT_LE(statistic(technique, "most intervals"), std::stod(capacity));
        EXPECT_EQ(texels > 0.0, statistic(technique, "compression error") > 0.0);
        EXPECT_LE(changed, last);
        EXPECT_LE(texels, lastTexels);
        if (texels == 0.0) {
            EXPECT_EQ(changed, 0u);
        }
        last = changed;
        lastTexels = texels;
    }
}

TEST(Intervals, BilinearTestsKeepTheMean) {
    IntervalsShadow technique(sharedRenderer().programs());
    const std::vector<float> one = visibilityOf(technique, {}), four = visibilityOf(technique, {{"bilinear", "on"}});
    EXPECT_GT(differences(one, four), 20u);
    EXPECT_NEAR(meanOf(one), meanOf(four), 0.01);
}

}  // namespace
}  // namespace timeshade
