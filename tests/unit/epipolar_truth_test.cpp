// What lies along a line of the light's map over the shutter: a quad that sweeps, whose edges are known, and the texels
// that a line crosses.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/procedural_scene.h"
#include "oracle/oracle.h"
#include "plan/map_line.h"

namespace timeshade {
namespace {

/// A light 10 above a large receiver, and a quad half-way whose centre goes from x = -1 to 1: it covers |x - c(u)| <=
/// 1/2, and y from -0.4 to 0.6. The receiver's triangles are 2 and 3.
std::shared_ptr<ProceduralScene> sweptScene() {
    auto scene = std::make_shared<ProceduralScene>();
    scene->quads = {slidingQuad({-1.0, 0.0, 5.0}, {1.0, 0.0, 5.0}, 0.5, -0.4, 0.6),
                    slidingQuad({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 30.0, -30.0, 30.0)};
    LightPose light;
    light.position = {0.0, 0.0, 10.0};
    light.outerConeAngle = 0.5;
    scene->lightOpen = scene->lightClose = light;
    CameraPose camera;
    camera.eye = {0.0, 0.0, 20.0};
    scene->cameraOpen = scene->cameraClose = camera;
    scene->finish("swept");
    return scene;
}

/// Of a place of the map at z = 5, from the light's image plane, not from the matrices that are tested.
double quadX(const FramePlan& plan, double s) { return 5.0 * (plan.light.open.corner.x + s * plan.light.open.right.x); }
double quadY(const FramePlan& plan, double t) { return 5.0 * (plan.light.open.corner.y + t * plan.light.open.up.y); }

TEST(EpipolarTruth, HasTheEdgesOfASweepingQuad) {
    const auto scene = sweptScene();
    const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(16, 16, 2, 64, 1));
    const Oracle oracle(plan);
    for (const MapLine line : {MapLine{{0.0, 0.5}, {1.0, 0.5}}, MapLine{{0.9, 0.5}, {0.1, 0.52}}}) {
        constexpr std::uint32_t columns = 150, rows = 90;
        const std::vector<SeenByLight> seen = oracle.seenAlong(plan, line, columns, rows);
        ASSERT_EQ(seen.size(), columns * rows);
        std::size_t covered = 0;
        for (std::uint32_t row = 0; row < rows; ++row) {
            for (std::uint32_t column = 0; column < columns; ++column) {
                const double u = (row + 0.5) / rows;
                const glm::dvec2 place = line.at((column + 0.5) / columns);
                ASSERT_LT(std::abs(quadY(plan, place.y) - 0.1), 0.49) << "the line crosses the quad's middle";
                const double inside = 0.5 - std::abs(quadX(plan, place.x) - (-1.0 + 2.0 * u));
                if (std::abs(inside) < 1e-5) continue;  // matrices are floats
                const SeenByLight& cell = seen[row * columns + column];
                ASSERT_EQ(cell.triangle<2, inside> 0.0) << "x " << quadX(plan, place.x) << " u " << u;
                ASSERT_LT(cell.triangle, 4u);
                ASSERT_NEAR(cell.depth, inside > 0.0 ? 5.0 : 10.0, 1e-5);
                covered += inside > 0.0 ? 1 : 0;
            }
        }
        EXPECT_GT(covered, 200u);
    }
}

TEST(EpipolarTruth, SeesNothingBesideTheScene) {
    auto scene = sweptScene();
    scene->quads[1] = slidingQuad({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.01, -0.01, 0.01);
    scene->finish("small");
    const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(16, 16, 2, 64, 1));
    const Oracle oracle(plan);
    EXPECT_EQ(oracle.seenByLight(plan, {0.02, 0.02}, 0.5).triangle, NO_TRIANGLE);
}

TEST(MapLine, ProjectsAsTheImagePlaneDoes) {
    const auto scene = sweptScene();
    const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(16, 16, 2, 64, 1));
    const glm::dvec3 point(0.7, -0.3, 5.0);
    const MapPlace place = mapPlaceOf(plan, point - plan.origin, 0.25);
    EXPECT_NEAR(place.depth, 5.0, 1e-5);
    EXPECT_NEAR(quadX(plan, place.position.x), 0.7, 1e-5);
    EXPECT_NEAR(quadY(plan, place.position.y), -0.3, 1e-5);
    const LightRay ray = lightRayThrough(plan, place.position, 0.25);
    EXPECT_LT(glm::length(ray.from + place.depth * ray.direction + plan.origin - point), 1e-5);
}

TEST(MapLine, KnowsPlacesAlongAndBesideIt) {
    const MapLine line{{0.25, 0.5}, {0.75, 0.5}};
    EXPECT_DOUBLE_EQ(line.alongOf({0.5, 0.9}), 0.5);
    EXPECT_DOUBLE_EQ(line.alongOf({1.0, 0.5}), 1.5);
    EXPECT_DOUBLE_EQ(line.texelsFrom({0.3, 0.75}, {100.0, 200.0}), 50.0);
    EXPECT_DOUBLE_EQ(line.texels({100.0, 200.0}), 50.0);
}

/// Without a gap, in order, each part inside its texel.
void expectWhole(const MapLine& line, const glm::ivec2& size, const std::vector<TexelOnLine>& texels) {
    ASSERT_FALSE(texels.empty());
    EXPECT_EQ(texels.back().xTo, 1.0);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const TexelOnLine& t = texels[i];
        EXPECT_LT(t.xFrom, t.xTo);
        EXPECT_EQ(t.xFrom, i > 0 ? texels[i - 1].xTo : 0.0);
        const glm::dvec2 middle = line.at(0.5 * (t.xFrom + t.xTo)) * glm::dvec2(size);
        EXPECT_EQ(glm::ivec2(glm::floor(middle)), t.texel);
        for (const double x : {t.xFrom, t.xTo})
            for (int axis = 0; axis < 2; ++axis)
                EXPECT_LE(std::abs(line.at(x)[axis] * size[axis] - t.texel[axis] - 0.5), 0.5 + 1e-9);
    }
}

TEST(MapLine, CrossesTheTexelsThatItShould) {
    const glm::ivec2 size(64, 48);
    for (const MapLine line :
         {MapLine{{0.0, 0.51}, {1.0, 0.51}}, MapLine{{0.9, 0.1}, {0.13, 0.77}}, MapLine{{0.3, 0.9}, {0.3, 0.05}}})
        expectWhole(line, size, texelsAlong(line, size));
    EXPECT_EQ(texelsAlong({{0.0, 0.51}, {1.0, 0.51}}, size).size(), 64u);
    // Through the corners of square texels: the diagonal alone.
    const std::vector<TexelOnLine> diagonal = texelsAlong({{0.0, 0.0}, {1.0, 1.0}}, {32, 32});
    EXPECT_EQ(diagonal.size(), 32u);
    for (const TexelOnLine& t : diagonal) EXPECT_EQ(t.texel.x, t.texel.y);
    // What lies outside of the map is in no texel.
    const std::vector<TexelOnLine> beyond = texelsAlong({{-0.5, 0.5}, {0.5, 0.5}}, {32, 32});
    ASSERT_EQ(beyond.size(), 16u);
    EXPECT_DOUBLE_EQ(beyond.front().xFrom, 0.5);
}

}  // namespace
}  // namespace timeshade
