// The runner, whose vertices follow bones, cloths that wave, trees, and the octopus with more triangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/scene_folder.h"
#include "scene/finer_scene.h"
#include "scene/gltf_scene.h"
#include "scenes/blobs.h"
#include "scenes/branches.h"
#include "scenes/cloth.h"
#include "scenes/run_cycle.h"
#include "scenes/scene_recipe.h"

namespace timeshade {
namespace {

using Place = std::array<double, 3>;

/// Edges that are not walked as often one way as the other.
std::size_t openEdges(const std::vector<glm::dvec3>& positions, const std::vector<glm::u32vec3>& triangles) {
    std::map<std::pair<Place, Place>, int> balance;
    for (const glm::u32vec3& triangle : triangles)
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 a = positions[triangle[i]], b = positions[triangle[(i + 1) % 3]];
            const Place from{a.x, a.y, a.z}, to{b.x, b.y, b.z};
            ++balance[{from, to}];
            --balance[{to, from}];
        }
    return static_cast<std::size_t>(
        std::count_if(balance.begin(), balance.end(), [](const auto& entry) { return entry.second != 0; }));
}

TEST(Blobs, AreClosedAndAsLargeAsTheySay) {
    const Blob ball{{0.0, 0.0, 0.0}, {0.0, 0.0, 1e-6}, 0.5, 0.5, 1.0, 0.02, 0, 0, glm::dvec3(0.0), 0.0};
    Blob cut = ball;
    cut.a.x = cut.b.x = 0.6;
    cut.layer = 1;
    cut.cutTo = {0.0, 1.0, 0.0};
    cut.cutAt = 0.2;
    const LayeredShape made = surfaceOf({ball, cut}, 0.03);
    EXPECT_EQ(openEdges(made.shape.positions, made.shape.triangles), 0u);
    std::size_t onCut = 0;
    for (std::size_t v = 0; v < made.layers.size(); ++v) {
        const glm::dvec3 p = made.shape.positions[v];
        EXPECT_NEAR(std::min(distanceTo(ball, p), distanceTo(cut, p)), 0.0, 0.012) << "off the surface";
        EXPECT_TRUE(made.layers[v] != 1 || p.y < 0.21);
        onCut += made.layers[v] == 1 && std::abs(p.y - 0.2) < 1e-3 ? 1 : 0;
    }
    EXPECT_GT(onCut, 100u);
    double volume = 0.0;  // six times that
    const LayeredShape round = surfaceOf({ball}, 0.03);
    for (const glm::u32vec3& t : round.shape.triangles)
        volume +=
            glm::dot(round.shape.positions[t.x], glm::cross(round.shape.positions[t.y], round.shape.positions[t.z]));
    EXPECT_NEAR(volume / 6.0, 4.0 / 3.0 * 3.14159265 * 0.125, 0.003) << "wound outwards";
}

TEST(RunCycle, FeetOnTheGroundStandStillAndBonesHoldTogether) {
    const auto [radius, strides] = roundTrack(4.0);
    EXPECT_NEAR(2.0 * 3.14159265358979 * radius, strides * strideLength, 1e-9);
    const Track track{radius};
    const RunnerJoints rest;
    for (const Side side : {left, right}) {
        const double begun = side == left ? 3.0 : 2.5;
        const auto ballAt = [&, side = side](double share) {
            return runningPose(begun + share, track)[boneOf(side, foot)].of(onSide(side, rest.ball));
        };
        for (double share = 0.0; share < 0.33; share += 0.03) {
            EXPECT_LT(glm::length(ballAt(share) - ballAt(0.0)), 1e-9);
            EXPECT_NEAR(ballAt(share).y, 0.0, 1e-9);
        }
        EXPECT_GT(glm::length(ballAt(0.7) - ballAt(0.0)), 0.5);
        for (double share = 0.0; share < 1.0; share += 0.01) {
            const std::vector<RigidPose> pose = runningPose(begun + share, track);
            const auto at = [&, side = side](LimbBone bone, const glm::dvec3& place) {
                return pose[boneOf(side, bone)].of(onSide(side, place));
            };
            EXPECT_GE(at(foot, rest.ball).y, -1e-9);
            EXPECT_GE(at(foot, {0.135, 0.0, -0.09}).y, -0.004) << "a heel in the ground at " << share;
            EXPECT_LT(glm::length(at(shin, rest.ankle) - at(foot, rest.ankle)), 0.012)
                << "a leg too short at " << share;
            EXPECT_LT(glm::length(at(shin, rest.knee) - at(thigh, rest.knee)), 1e-9);
            EXPECT_LT(glm::length(at(forearm, rest.elbow) - at(upperArm, rest.elbow)), 1e-9);
        }
    }
    const std::vector<RigidPose> first = runningPose(0.25, track), last = runningPose(0.25 + strides, track);
    for (std::size_t bone = 0; bone < first.size(); ++bone) EXPECT_LT(degreesBetween(first[bone], last[bone]), 1e-4);
}

TEST(BodyScenes, HaveAsManyTrianglesAsTheySay) {
    const auto triangles = [](const char* name) {
        return static_cast<double>(makeRecipe(name)->make()->motionMesh(0.0, 0.0).topology->triangles.size());
    };
    EXPECT_NEAR(triangles("leg"), 265000.0, 1000.0);
    EXPECT_NEAR(triangles("tree"), 112000.0, 1000.0);
    EXPECT_NEAR(triangles("runner"), 163000.0, 1000.0);
    EXPECT_NEAR(triangles("octopus-fine"), 190001.5, 1.6);
}

TEST(BodyScenes, TheRunnerIsClosedAndColoured) {
    const RunnerBody& body = runnerBody(0.014);
    EXPECT_EQ(openEdges(body.shape->positions, body.shape->triangles), 0u);
    std::set<float> reds;
    for (const glm::vec3& colour : body.shape->colours) reds.insert(colour.x);
    EXPECT_GE(reds.size(), 6u) << "skin, singlet, shorts, shoes, soles, hair";
    for (const Influences& follows : body.influences)
        EXPECT_NEAR(follows.shares[0] + follows.shares[1] + follows.shares[2] + follows.shares[3], 1.0, 1e-12);
}

TEST(BodyScenes, ClothsHangFromTheirRods) {
    Cloth cloth;
    cloth.place.position = {1.0, 3.0, 2.0};
    const auto shape = hangingCloth(cloth);
    const auto waves = wavingCloth(cloth);
    std::vector<std::uint32_t> all(shape->positions.size());
    for (std::uint32_t v = 0; v < all.size(); ++v) all[v] = v;
    std::vector<glm::dvec3> positions(all.size()), later(all.size());
    waves->bend(0.1, all, positions.data(), nullptr);
    waves->bend(0.1 + cloth.period, all, later.data(), nullptr);
    double most = 0.0;
    for (std::size_t v = 0; v < all.size(); ++v) {
        EXPECT_LT(glm::length(later[v] - positions[v]), 1e-9);
        EXPECT_TRUE(v > static_cast<std::size_t>(cloth.columns) || std::abs(positions[v].y - 3.0) < 1e-12) << v;
        most = std::max(most, glm::length(positions[v] - shape->positions[v]));
    }
    EXPECT_GT(most, 0.5 * cloth.size);
}

TEST(FinerScene, KeepsWhatWasThereAndClosesWhatItDivides) {
    const auto bare = loadGltf(sceneFolder() / "octopus.glb");
    const FinerScene finer(loadGltf(sceneFolder() / "octopus.glb"), 120000, "finer", {{"triangles", 120000.0}});
    const MotionMesh before = bare->motionMesh(1.0, 1.04), after = finer.motionMesh(1.0, 1.04);
    EXPECT_TRUE(std::equal(before.positionsOpen.begin(), before.positionsOpen.end(), after.positionsOpen.begin()));
    EXPECT_GE(after.topology->triangles.size(), 120000u);
    EXPECT_LE(after.topology->triangles.size(), 120003u);
    EXPECT_EQ(openEdges(after.positionsClose, after.topology->triangles), 0u);
    // Round things become rounder: no new vertex is far from the surface, and most are not on the old edge.
    EXPECT_EQ(finer.contentDigest(), "finer triangles=120000 of " + bare->contentDigest());
    double longest = 0.0;
    for (const glm::u32vec3& t : after.topology->triangles)
        if (before.positionsOpen.size() <= t.x)
            longest = std::max(longest, glm::length(after.positionsOpen[t.x] - after.positionsOpen[t.y]));
    EXPECT_LT(longest, 0.25);
}

/// The shape with vertices of its own for each triangle, on its way.
MotionMesh onItsWay(const Shape& shape) {
    auto topology = std::make_shared<MeshTopology>();
    MotionMesh mesh;
    for (const glm::u32vec3& triangle : shape.triangles) {
        const auto first = static_cast<std::uint32_t>(mesh.positionsOpen.size());
        for (int i = 0; i < 3; ++i) {
            mesh.positionsOpen.push_back(shape.positions[triangle[i]]);
            mesh.normalsOpen.push_back(shape.normals[triangle[i]]);
        }
        topology->triangles.emplace_back(first, first + 1, first + 2);
        topology->triangleMaterials.push_back(0);
        topology->triangleInstances.push_back(0);
    }
    topology->vertexCount = mesh.positionsOpen.size();
    mesh.positionsClose = mesh.positionsOpen;
    for (glm::dvec3& p : mesh.positionsClose) p.x += 1.0;
    mesh.normalsClose = mesh.normalsOpen;
    mesh.topology = topology;
    return mesh;
}

TEST(EdgeSplits, RoundWhatIsRoundAndKeepCreases) {
    for (const bool round : {true, false}) {
        const Shape shape = round ? geodesicSphere(3) : turned({{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.5}, {0.0, 0.5}}, 8);
        MotionMesh mesh = onItsWay(shape);
        const std::size_t wanted = (round ? 2 : 4) * shape.triangles.size(), before = mesh.positionsOpen.size();
        const EdgeSplits splits(mesh, wanted);
        const MeshTopology divided = splits.divided(*mesh.topology);
        EXPECT_GE(divided.triangles.size(), wanted);
        EXPECT_LE(divided.triangles.size(), wanted + 3);
        splits.append(mesh.positionsOpen, mesh.normalsOpen);
        ASSERT_EQ(mesh.positionsOpen.size(), divided.vertexCount);
        EXPECT_EQ(openEdges(mesh.positionsOpen, divided.triangles), 0u);
        for (std::size_t v = before; v < mesh.positionsOpen.size(); ++v) {
            const glm::dvec3 p = mesh.positionsOpen[v];
            if (round)
                EXPECT_NEAR(glm::length(p), 1.0, 0.004) << "the edges' own middles are at 0.97 and less";
            else
                EXPECT_TRUE(std::hypot(p.x, p.z) < 0.95 || std::abs(p.y - 0.25) < 0.01)
                    << "the rim of a drum is a crease";
        }
    }
    MotionMesh still = onItsWay(geodesicSphere(2));
    still.positionsClose = still.positionsOpen;
    EXPECT_EQ(EdgeSplits(still, 500).divided(*still.topology).triangles.size(), 80u) << "what stands still stays";
}

TEST(Branches, BearTheirSpraysOnTheWood) {
    const Branches branches = grownBranches(1, 50);
    ASSERT_EQ(branches.sprays.size(), 50u);
    EXPECT_EQ(openEdges(branches.wood.positions, branches.wood.triangles), 0u);
    for (const glm::dvec3& p : branches.wood.positions) {
        EXPECT_LT(p.y, treeHeight);
        EXPECT_LT(std::hypot(p.x, p.z), treeReach);
    }
    for (const RigidPose& spray : branches.sprays) {
        double nearest = 1e9;
        for (const glm::dvec3& p : branches.wood.positions)
            nearest = std::min(nearest, glm::length(p - spray.position));
        EXPECT_LT(nearest, 0.2) << "as far as a piece of a twig is long";
    }
}

}  // namespace
}  // namespace timeshade
