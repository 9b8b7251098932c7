// The ground that is added to files: when, where and how large.

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "../broken_gltf/box_file.h"
#include "../broken_gltf/loaded.h"
#include "scene/ground_fit.h"
#include "scene/grounded_scene.h"

namespace timeshade {
namespace {

using namespace test;

std::unique_ptr<GroundedScene> grounded(const GltfFile& file, const GroundSettings& settings = {}) {
    return std::make_unique<GroundedScene>(loaded(file), settings);
}

GroundSettings choice(GroundChoice choice) { return {choice, {}, {}}; }

/// A horizontal quad that faces up.
void addFloor(GltfFile& file, float half, float height, float centre = 0.0f) {
    const int positions = file.vec3s({centre - half, height, half, centre + half, height, half, centre + half, height,
                                      -half, centre - half, height, -half});
    file.addRoot({{"name", "floor"},
                  {"mesh", file.addMesh({{"POSITION", positions}},
                                        file.addAccessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR", 1))}});
}

TEST(Ground, LiesBelowTheLowestPointOfTheClip) {
    // The box is lowest at a key that no even division of its three seconds meets.
    const auto scene = grounded(fileWithBouncingBox());
    ASSERT_TRUE(scene->ground().has_value());
    EXPECT_NEAR(scene->ground()->centre.y, 0.25 - groundGap * scene->bounds().diagonal(), 1e-9);
    EXPECT_EQ(notesWith(*scene, "a ground is added at the height 0.249"), 1u);
}

TEST(Ground, HoldsTheShadowOfAllThatMoves) {
    const auto scene = grounded(fileWithBouncingBox());
    const GroundSquare& square = *scene->ground();
    double farthest = 0.0;
    for (const double seconds : {0.0, 0.4, 1.0, 1.7, 2.9}) {
        const MotionMesh mesh = scene->bare().motionMesh(seconds, seconds);
        const LightPose light = scene->light(seconds);
        for (const glm::dvec3& p : mesh.positionsOpen) {
            const glm::dvec3 away = p - light.position;
            const glm::dvec3 place = p + away * ((square.centre.y - p.y) / away.y) - square.centre;
            farthest = std::max({farthest, std::abs(place.x), std::abs(place.z)});
        }
    }
    EXPECT_LT(farthest, 0.5 * square.side);
    EXPECT_GT(farthest, 0.15 * square.side) << "far larger than it must be";
}

TEST(Ground, IsOneMoreMeshAndChangesNothingElse) {
    const GltfFile file = fileWithBouncingBox();
    const auto with = grounded(file), without = grounded(file, choice(GroundChoice::Off));
    const MotionMesh mesh = with->motionMesh(0.5, 0.6), bare = without->motionMesh(0.5, 0.6);
    const MeshTopology &topology = *mesh.topology, &other = *bare.topology;
    EXPECT_EQ(topology.triangles.size(), other.triangles.size() + 2);
    EXPECT_EQ(topology.instanceCount, other.instanceCount + 1);
    EXPECT_EQ(topology.vertexCount, other.vertexCount + 4);
    EXPECT_EQ(topology.vertexCount, mesh.positionsOpen.size());
    EXPECT_EQ(topology.vertexCount, topology.textureCoordinates.size());
    EXPECT_TRUE(std::equal(bare.positionsOpen.begin(), bare.positionsOpen.end(), mesh.positionsOpen.begin()));
    EXPECT_TRUE(std::equal(other.triangles.begin(), other.triangles.end(), topology.triangles.begin()));
    EXPECT_EQ(with->materials()[topology.triangleMaterials.back()].name, "ground");
    EXPECT_EQ(with->motionMesh(0.1, 0.2).topology, mesh.topology) << "uploaded anew";
    const glm::u32vec3 last = topology.triangles.back();
    const glm::dvec3 up = glm::cross(mesh.positionsOpen[last.y] - mesh.positionsOpen[last.x],
                                     mesh.positionsOpen[last.z] - mesh.positionsOpen[last.x]);
    EXPECT_GT(up.y, 0.0);
    EXPECT_EQ(with->bounds().low, without->bounds().low);
    EXPECT_NE(with->contentDigest(), without->contentDigest());
    EXPECT_FALSE(without->ground().has_value());
    EXPECT_EQ(without->notes(), without->bare().notes());
}

TEST(Ground, IsWhereAndAsLargeAsAskedFor) {
    const GltfFile file = fileWithBouncingBox();
    const auto scene = grounded(file, {GroundChoice::On, -1.5, 12.0});
    EXPECT_EQ(scene->ground()->centre.y, -1.5);
    EXPECT_EQ(scene->ground()->side, 12.0);
    EXPECT_EQ(notesWith(*scene, "a ground is added"), 0u);
    const GroundedScene again(*scene, choice(GroundChoice::Auto));
    EXPECT_EQ(again.ground(), grounded(file)->ground());
    EXPECT_FALSE(GroundedScene(again, choice(GroundChoice::Off)).ground().has_value());
}

TEST(Ground, IsNotAddedToWhatHasOne) {
    GltfFile file = fileWithBouncingBox();
    addFloor(file, 8.0f, 0.0f);
    EXPECT_FALSE(grounded(file)->ground().has_value());
    EXPECT_TRUE(grounded(file, choice(GroundChoice::On))->ground().has_value());

    GltfFile still;
    still.addRoot({{"mesh", addBox(still, {-0.5f, 0.0f, -0.5f}, {0.5f, 1.0f, 0.5f})}});
    EXPECT_TRUE(grounded(still)->ground().has_value()) << "its own lower side faces down";
    addFloor(still, 8.0f, 0.0f);
    EXPECT_FALSE(grounded(still)->ground().has_value());
}

TEST(Ground, IsAddedWhereAFloorIsNoHelp) {
    const auto lacks = [](float half, float height, float centre) {
        GltfFile file = fileWithBouncingBox();
        addFloor(file, half, height, centre);
        return grounded(file)->ground().has_value();
    };
    EXPECT_FALSE(lacks(8.0f, 0.0f, 0.0f));
    EXPECT_TRUE(lacks(0.4f, 0.0f, 0.0f)) << "too small";
    EXPECT_TRUE(lacks(8.0f, 9.0f, 0.0f)) << "above";
    EXPECT_TRUE(lacks(8.0f, 0.0f, 30.0f)) << "elsewhere";
}

TEST(Ground, IsSeenByTheFittedCameraAndByNoOther) {
    GltfFile file = fileWithBouncingBox();
    const auto farFromCentre = [](const Scene& scene) {
        return glm::length(scene.camera(0, 0.0).eye - scene.bounds().centre());
    };
    EXPECT_GT(farFromCentre(*grounded(file)), 1.05 * farFromCentre(*grounded(file, choice(GroundChoice::Off))));
    file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}});
    file.addRoot({{"camera", 0}, {"translation", {0, 1, 5}}});
    EXPECT_EQ(grounded(file)->camera(0, 0.0).eye, glm::dvec3(0, 1, 5));
}

TEST(Ground, AnyScaleWillDo) {
    for (const double scale : {1e-3, 1.0, 1e4}) {
        GltfFile file = fileWithBouncingBox();
        file.json["nodes"].push_back({{"children", {0}}, {"scale", {scale, scale, scale}}});
        file.json["scenes"][0]["nodes"] = {1};
        const auto scene = grounded(file);
        ASSERT_TRUE(scene->ground().has_value());
        EXPECT_NEAR(scene->ground()->side / scale, grounded(fileWithBouncingBox())->ground()->side, 1e-5);
    }
}

}  // namespace
}  // namespace timeshade
