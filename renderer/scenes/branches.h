#pragma once

#include <cstdint>
#include <vector>

#include "scenes/mesh_scene.h"

namespace timeshade {

/// A closed round bar along a line, tapering evenly between two radii, whose ends are cones. At least two points, no
/// two neighbours alike; sides >= 3.
Shape bar(const std::vector<glm::dvec3>& line, double firstRadius, double lastRadius, int sides);

/// The wood of a tree that stands at the origin, and where its twigs end.
struct Branches {
    Shape wood;
    /// Where a spray of leaves begins: y points along it, away from the wood.
    std::vector<RigidPose> sprays;
};

/// Grown from a seed, with so many sprays; equal arguments make equal trees.
Branches grownBranches(std::uint32_t seed, int sprays);

/// A twig along y from the origin with 14 leaves, folded along their ribs: 112 triangles of leaves, each seen from both
/// sides.
Shape sprayOfLeaves(std::uint32_t seed);

/// The height of the tree's top and the reach of its branches, at most, sprays excluded.
inline constexpr double treeHeight = 7.2, treeReach = 3.6;

}  // namespace timeshade
