// Computed scenes: the triangles that they promise, closed and where they say, moving as they say, the same every time.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "core/error.h"
#include "scenes/mesh_scene.h"
#include "scenes/scene_recipe.h"

namespace timeshade {
namespace {

using SettingText = std::pair<const char*, const char*>;

std::unique_ptr<Scene> made(const std::string& name, const std::vector<SettingText>& settings = {}) {
    const std::unique_ptr<SceneRecipe> recipe = makeRecipe(name);
    for (const auto& [key, text] : settings) setFromText(*recipe, key, text);
    return recipe->make();
}

/// One frame of the shutter that the scene suggests, opened at its start.
MotionMesh frameOf(const Scene& scene, double frame, double length) {
    const double rate = scene.defaults().framesPerSecond;
    return scene.motionMesh(frame / rate, (frame + length) / rate);
}

using Corner = std::array<double, 3>;
Corner corner(const glm::dvec3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

std::size_t trianglesOfInstance(const MeshTopology& topology, std::uint32_t instance) {
    return static_cast<std::size_t>(
        std::count(topology.triangleInstances.begin(), topology.triangleInstances.end(), instance));
}

/// Directed edges of an instance that have no partner in the opposite direction, by the positions of their ends.
std::size_t openEdges(const MotionMesh& mesh, std::uint32_t instance) {
    std::map<std::pair<Corner, Corner>, int> balance;
    for (std::size_t t = 0; t < mesh.topology->triangles.size(); ++t) {
        if (mesh.topology->triangleInstances[t] != instance) continue;
        for (int i = 0; i < 3; ++i) {
            const Corner a = corner(mesh.positionsClose[mesh.topology->triangles[t][i]]);
            const Corner b = corner(mesh.positionsClose[mesh.topology->triangles[t][(i + 1) % 3]]);
            ++balance[{a, b}];
            --balance[{b, a}];
        }
    }
    return static_cast<std::size_t>(
        std::count_if(balance.begin(), balance.end(), [](const auto& entry) { return entry.second != 0; }));
}

/// The same scene of fewer triangles, where it has many.
std::vector<SettingText> light(const std::string& name) {
    if (name == "tree") return {{"sprays", "60"}};
    if (name == "leg" || name == "runner") return {{"cell", "16"}};
    if (name == "octopus-fine") return {{"triangles", "80000"}};
    return {};
}

TEST(SceneRecipes, EveryDeclarationIsWhole) {
    ASSERT_EQ(recipeDescriptions().size(), 13u);
    EXPECT_EQ(makeRecipe("nonsense"), nullptr);
    for (const RecipeDescription& description : recipeDescriptions()) {
        const std::unique_ptr<SceneRecipe> recipe = makeRecipe(description.name);
        ASSERT_NE(recipe, nullptr);
        const std::vector<Setting> settings = settingsOf(*recipe);
        EXPECT_FALSE(settings.empty());
        for (const Setting& setting : settings) {
            SCOPED_TRACE(description.name + "." + setting.key);
            EXPECT_FLOAT_EQ(static_cast<float>(setting.get()), static_cast<float>(setting.defaultValue))
                << "a new recipe starts with its defaults";
            EXPECT_TRUE(setting.minimum <= setting.defaultValue && setting.defaultValue <= setting.maximum);
        }
        EXPECT_THROW(setFromText(*recipe, "nonsense", "1"), UsageError);
        for (const auto& [key, text] : light(description.name)) setFromText(*recipe, key, text);
        const std::unique_ptr<Scene> scene = recipe->make();
        EXPECT_EQ(scene->name(), description.name);
        EXPECT_EQ(scene->parameters().size(), settings.size());
    }
}

TEST(SceneRecipes, StayInBoundsAreClosedAndRepeat) {
    for (const RecipeDescription& description : recipeDescriptions()) {
        SCOPED_TRACE(description.name);
        const auto settings = light(description.name);
        const std::unique_ptr<Scene> scene = made(description.name, settings), again = made(description.name, settings);
        const double frames = std::round(scene->duration() * scene->defaults().framesPerSecond);
        EXPECT_GT(frames, 1.0);
        for (const double frame : {0.0, 5.5, frames - 0.25, frames + 7.0, -3.0}) {
            const MotionMesh mesh = frameOf(*scene, frame, 1.0), same = frameOf(*again, frame, 1.0);
            EXPECT_EQ(mesh.positionsOpen, same.positionsOpen) << "not the same scene";
            EXPECT_EQ(mesh.positionsClose, same.positionsClose);
            const MotionMesh later = frameOf(*scene, frame + frames, 1.0);
            double apart = 0.0;
            for (std::size_t v = 0; v < mesh.positionsOpen.size(); ++v) {
                apart = std::max(apart, glm::length(later.positionsClose[v] - mesh.positionsClose[v]));
                EXPECT_NEAR(glm::length(mesh.normalsClose[v]), 1.0f, 1e-5f);
                for (int axis = 0; axis < 3; ++axis) {
                    ASSERT_GE(mesh.positionsClose[v][axis], scene->bounds().low[axis]);
                    ASSERT_LE(mesh.positionsClose[v][axis], scene->bounds().high[axis]);
                }
            }
            EXPECT_LT(apart, 1e-9) << "does not repeat";
        }
        const MotionMesh mesh = frameOf(*scene, 3.0, 1.0);
        EXPECT_EQ(openEdges(mesh, 0) > 0, description.name != "octopus-fine")
            << "the ground is a plane, so the count of open edges counts; sand is a slab";
        const bool hasQuads =
            description.name == "crossing" || description.name == "depths" || description.name == "foliage";
        for (std::uint32_t i = 1; i < std::min<std::size_t>(mesh.topology->instanceCount, 40); ++i) {
            // Four sides of a quad, in both directions; six of each of 14 leaves, behind the wood.
            const std::size_t open = hasQuads ? 8 : description.name == "tree" && i > 1 ? 14 * 6 * 2 : 0;
            EXPECT_EQ(openEdges(mesh, i), open) << i;
        }
    }
}

TEST(SceneRecipes, CubesFlyAsFarAsTheyAreTold) {
    for (const char* speed : {"1", "8", "16"}) {
        const std::unique_ptr<Scene> scene = made("cubes", {{"count", "300"}, {"speed", speed}, {"turn", "0"}});
        const MotionMesh mesh = frameOf(*scene, 17.0, 1.0);
        ASSERT_EQ(mesh.topology->instanceCount, 301u);
        EXPECT_EQ(trianglesOfInstance(*mesh.topology, 300), 12u);
        EXPECT_EQ(mesh.largestTurnDegrees, 0.0);
        double least = 1e9, most = 0.0;
        for (std::size_t v = mesh.positionsOpen.size() - 300 * 24; v < mesh.positionsOpen.size(); ++v) {
            const double way = glm::length(mesh.positionsClose[v] - mesh.positionsOpen[v]) / 0.4;
            least = std::min(least, way);
            most = std::max(most, way);
        }
        EXPECT_NEAR(least, 0.5 * std::atof(speed), 0.02 * std::atof(speed));
        EXPECT_NEAR(most, std::atof(speed), 0.02 * std::atof(speed));
    }
}

TEST(SceneRecipes, CubesAreThoseOfTheirSeedAndNumber) {
    const auto positions = [](const std::vector<SettingText>& settings) {
        return frameOf(*made("cubes", settings), 0.0, 1.0).positionsOpen;
    };
    const std::vector<glm::dvec3> few = positions({{"count", "50"}}), many = positions({{"count", "100"}});
    EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin())) << "more cubes leave the others where they were";
    EXPECT_NE(few, positions({{"count", "50"}, {"seed", "2"}}));
    const std::unique_ptr<Scene> motionless = made("cubes", {{"speed", "0"}, {"turn", "0"}});
    EXPECT_EQ(motionless->duration(), 0.0);
    const MotionMesh mesh = frameOf(*motionless, 3.0, 1.0);
    EXPECT_EQ(mesh.positionsOpen, mesh.positionsClose);
}

TEST(SceneRecipes, RisingCubesRiseOnly) {
    const std::unique_ptr<Scene> scene = made("rising", {{"speed", "0.5"}});
    const MotionMesh mesh = frameOf(*scene, scene->defaults().frame, 1.0);
    EXPECT_EQ(trianglesOfInstance(*mesh.topology, 1) + trianglesOfInstance(*mesh.topology, 2), 12000u);
    double most = 0.0;
    for (std::size_t v = 0; v < mesh.positionsOpen.size(); ++v) {
        const glm::dvec3 way = mesh.positionsClose[v] - mesh.positionsOpen[v];
        EXPECT_EQ(way.x, 0.0);
        EXPECT_EQ(way.z, 0.0);
        most = std::max(most, way.y);
    }
    EXPECT_NEAR(most, 0.5 * 2.4, 0.01) << "half a cube in the frame in which they are fastest";
    EXPECT_EQ(mesh.largestTurnDegrees, 0.0);
}

TEST(SceneRecipes, OnlyTheCameraOfTheFrustaMoves) {
    const std::unique_ptr<Scene> scene = made("frusta");
    const MotionMesh mesh = frameOf(*scene, 30.0, 1.0);
    EXPECT_EQ(mesh.positionsOpen, mesh.positionsClose);
    ASSERT_EQ(scene->cameras().size(), 2u);
    EXPECT_EQ(scene->cameras()[1].name, "path");
    const glm::dvec3 eye = scene->camera(0, 0.0).eye;
    EXPECT_EQ(scene->camera(0, 3.0).eye, eye);
    EXPECT_GT(glm::length(scene->camera(1, 3.0).eye - eye), 0.5);
    EXPECT_LT(glm::length(scene->camera(1, 3.0).eye - scene->camera(1, 3.0 + 1.0 / 24.0).eye), 0.15);
    // They face one another.
    const glm::dvec3 light = scene->light(0.0).axes[2], camera = scene->camera(0, 0.0).axes[2];
    EXPECT_LT(glm::dot(light, camera), -0.8);
}

/// The centre of one of the quads of `crossing` and `depths`, at both ends of the shutter.
std::array<glm::dvec3, 2> centres(const MotionMesh& mesh, std::uint32_t instance) {
    std::array<glm::dvec3, 2> sum{glm::dvec3(0.0), glm::dvec3(0.0)};
    const std::size_t ofGround = mesh.positionsOpen.size() - 8;  // two quads of four vertices stand last
    for (std::size_t v = ofGround + 4 * (instance - 1); v < ofGround + 4 * instance; ++v) {
        sum[0] += 0.25 * mesh.positionsOpen[v];
        sum[1] += 0.25 * mesh.positionsClose[v];
    }
    return sum;
}

TEST(SceneRecipes, TheQuadsCrossOnOneRayOfTheLight) {
    for (const char* angle : {"0", "90", "180"}) {
        SCOPED_TRACE(angle);
        const std::unique_ptr<Scene> scene =
            made("crossing", {{"angle", angle}, {"speed", "0.5"}, {"distance", "1.5"}});
        const double frame = scene->defaults().frame;
        const MotionMesh mesh = frameOf(*scene, frame, 1.0);
        const auto lower = centres(mesh, 1), upper = centres(mesh, 2);
        const glm::dvec3 lowerWay = lower[1] - lower[0], upperWay = upper[1] - upper[0];
        EXPECT_NEAR(glm::length(lowerWay), 0.5 * 2.4, 1e-12);
        EXPECT_NEAR(glm::length(upperWay), 0.5 * 2.4, 1e-12);
        EXPECT_NEAR(glm::dot(lowerWay, upperWay) / (1.2 * 1.2), std::cos(glm::radians(std::atof(angle))), 1e-12);
        EXPECT_NEAR(upper[0].y - lower[0].y, 1.5 * 2.4, 1e-12);
        // At the centre of the frame both shadow the origin.
        for (const auto& ends : {lower, upper}) {
            const glm::dvec3 light = scene->light(0.0).position, middle = 0.5 * (ends[0] + ends[1]);
            EXPECT_LT(glm::length(glm::cross(glm::normalize(middle), glm::normalize(light))), 1e-12);
        }
        // The motion of the frames beside it is the same: the default frame is inside of it.
        for (const double other : {frame - 1.0, frame - 0.5, frame + 1.0}) {
            const auto ends = centres(frameOf(*scene, other, 1.0), 1);
            EXPECT_LT(glm::length(ends[1] - ends[0] - lowerWay), 1e-12) << other;
        }
    }
    EXPECT_EQ(made("crossing", {{"speed", "0"}})->duration(), 0.0);
}

TEST(SceneRecipes, TheQuadsOfDepthsMoveAlongTheLightsRaysAndNeverTouch) {
    const std::unique_ptr<Scene> scene = made("depths");
    const glm::dvec3 light = scene->light(0.0).position;
    const MotionMesh mesh = frameOf(*scene, scene->defaults().frame, 1.0);
    for (const std::uint32_t quad : {1u, 2u}) {
        const auto ends = centres(mesh, quad);
        const glm::dvec3 way = ends[1] - ends[0];
        EXPECT_NEAR(glm::length(way), 0.7 * 2.0, 1e-7) << "0.7 is no float";
        EXPECT_NEAR(glm::dot(glm::normalize(way), glm::normalize(light - ends[0])), quad == 1 ? 1.0 : -1.0, 1e-12);
        EXPECT_TRUE(quad == 2 || ends[0].y < glm::length(way)) << "moves farther than its gap to the ground";
        const auto later = centres(frameOf(*scene, scene->defaults().frame + 0.25, 1.0), quad);
        EXPECT_LT(glm::length(later[1] - later[0] - way), 1e-12) << "the default frame is inside of the motion";
    }
    const std::unique_ptr<Scene> fast = made("depths", {{"speed", "1"}, {"distance", "0.05"}});
    for (double frame = 0.0; frame < 3.0; frame += 0.25) {
        const MotionMesh now = frameOf(*fast, frame, 0.0);
        EXPECT_GT(centres(now, 1)[0].y, 0.1);
        EXPECT_GT(centres(now, 2)[0].y - centres(now, 1)[0].y, 0.099);
    }
    const std::unique_ptr<Scene> high = made("depths", {{"speed", "1"}, {"distance", "0.8"}});
    EXPECT_LT(high->bounds().high.y, high->light(0.0).position.y) << "the light is above everything";
    EXPECT_EQ(made("depths", {{"speed", "0"}})->duration(), 0.0);
}

TEST(SceneRecipes, TheStoneIsConvex) {
    const std::unique_ptr<Scene> scene = made("sphere", {{"frequency", "8"}});
    const MotionMesh mesh = frameOf(*scene, 11.0, 1.0);
    ASSERT_EQ(trianglesOfInstance(*mesh.topology, 1), 1280u);
    for (std::size_t t = 0; t < mesh.topology->triangles.size(); ++t) {
        if (mesh.topology->triangleInstances[t] != 1) continue;
        const glm::u32vec3& triangle = mesh.topology->triangles[t];
        const glm::dvec3 a = mesh.positionsOpen[triangle.x];
        const glm::dvec3 normal =
            glm::normalize(glm::cross(mesh.positionsOpen[triangle.y] - a, mesh.positionsOpen[triangle.z] - a));
        EXPECT_GT(glm::dot(normal, glm::dvec3(mesh.normalsOpen[triangle.x])), 0.9) << "faces inwards";
        for (std::size_t v = mesh.positionsOpen.size() - 642; v < mesh.positionsOpen.size(); ++v)
            ASSERT_LT(glm::dot(mesh.positionsOpen[v] - a, normal), 1e-9) << "lies outside of triangle " << t;
    }
    EXPECT_EQ(trianglesOfInstance(*made("sphere")->motionMesh(0.0, 0.0).topology, 1), 20480u);
}

}  // namespace
}  // namespace timeshade
