// Which surfaces may lose the triangles that face away from the light: those without a border, outside of which camera
// and light are all through the shutter, and whose back faces the camera never sees from inside.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "culling/closed_surfaces.h"
#include "culling/self_crossing.h"
#include "scenes/shape.h"

namespace timeshade {
namespace {

Shape reversed(Shape shape) {
    for (glm::u32vec3& t : shape.triangles) std::swap(t.y, t.z);
    return shape;
}

Shape shifted(Shape shape, const glm::dvec3& by) {
    for (glm::dvec3& p : shape.positions) p += by;
    return shape;
}

Shape both(Shape a, const Shape& b) {
    a.add(b);
    return a;
}

Shape without(Shape shape, std::size_t triangle) {
    shape.triangles.erase(shape.triangles.begin() + static_cast<std::ptrdiff_t>(triangle));
    return shape;
}

/// Shapes repeat vertices where their normals differ; here those at one position are one.
bool meetsItself(const Shape& shape) {
    std::vector<glm::u32vec3> triangles = shape.triangles;
    for (glm::u32vec3& t : triangles)
        for (int corner = 0; corner < 3; ++corner)
            t[corner] = static_cast<std::uint32_t>(
                std::find(shape.positions.begin(), shape.positions.end(), shape.positions[t[corner]]) -
                shape.positions.begin());
    return mayCrossItself(shape.positions, triangles);
}

const Shape cube = box(glm::dvec3(1.0), glm::ivec3(2));

class ClosedSurfacesTest : public testing::Test {
  protected:
    ClosedSurfacesTest() {
        camera_.open.eye = camera_.close.eye = {0.0, 0.0, 10.0};
        light_.open.eye = light_.close.eye = {0.0, 6.0, 6.0};
        aim(camera_, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, 0.1);
        aim(light_, glm::normalize(glm::dvec3(0.0, -1.0, -1.0)), {1.0, 0.0, 0.0}, 0.01);
    }

    static void aim(ViewPlan& view, const glm::dvec3& forward, const glm::dvec3& up, double nearDistance) {
        const glm::dvec3 right = glm::cross(forward, up);
        for (ViewEnd* end : {&view.open, &view.close}) {
            end->right = right;
            end->up = up;
            end->corner = forward - 0.5 * right - 0.5 * up;
        }
        finishView(view, {64, 64}, nearDistance, 0.0);
    }

    void add(const Shape& shape, std::uint32_t material = 0) {
        const auto first = static_cast<std::uint32_t>(mesh_.positionsOpen.size());
        for (const glm::dvec3& p : shape.positions) mesh_.positionsOpen.push_back(p);
        for (const glm::u32vec3& t : shape.triangles) {
            topology_.triangles.push_back(t + first);
            topology_.triangleMaterials.push_back(material);
            topology_.triangleInstances.push_back(static_cast<std::uint32_t>(topology_.instanceCount));
        }
        ++topology_.instanceCount;
        topology_.vertexCount = mesh_.positionsOpen.size();
        mesh_.positionsClose = mesh_.positionsOpen;
        mesh_.topology = std::make_shared<const MeshTopology>(topology_);
    }

    ClosedSurfaces surfaces() const {
        Material twoSided;
        twoSided.doubleSided = true;
        return ClosedSurfaces(mesh_, {Material{}, twoSided});
    }

    std::vector<char> pairs() const { return surfaces().facingAwayCullable(mesh_, glm::dvec3(0.0), camera_, light_); }

    MeshTopology topology_;
    MotionMesh mesh_;
    ViewPlan camera_, light_;
};

TEST_F(ClosedSurfacesTest, AreTheOnesWithoutABorder) {
    add(cube);
    add(plane(4.0, 4.0, 3));
    add(without(cube, 7));
    add(both(cube, shifted(geodesicSphere(3), {5.0, 0.0, 0.0})));
    add(turned({{0.0, -1.0}, {0.6, -0.5}, {0.2, 0.1}, {0.5, 0.6}, {0.0, 1.0}}, 9));
    const ClosedSurfaces found = surfaces();
    EXPECT_EQ(found.count(), 4u);
    std::vector<std::size_t> sizes(found.count() + 1);
    for (const std::uint32_t surface : found.ofTriangles()) ++sizes.at(surface);
    const std::size_t outside = 18 + cube.triangles.size() - 1,
                      round = topology_.triangles.size() - outside - 2 * cube.triangles.size() - 180;
    EXPECT_EQ(sizes, (std::vector<std::size_t>{outside, cube.triangles.size(), cube.triangles.size(), 180, round}));
    EXPECT_EQ(pairs(), (std::vector<char>{0, 1, 1, 1, 1}));
}

TEST_F(ClosedSurfacesTest, NeedOneSense) {
    Shape shape = cube;
    std::swap(shape.triangles[5].x, shape.triangles[5].y);
    add(shape, 1);
    EXPECT_EQ(surfaces().count(), 0u);
}

TEST_F(ClosedSurfacesTest, OneSidedOnesMustNotBeInsideOut) {
    add(reversed(cube));
    EXPECT_EQ(surfaces().count(), 0u);
    add(reversed(cube), 1);  // a back face that is seen would be missing
    EXPECT_EQ(surfaces().count(), 1u);
}

TEST_F(ClosedSurfacesTest, OneSidedOnesMustNotCrossThemselves) {
    // An hourglass whose lower half is inside out: its waist is pulled through itself.
    Shape glass = turned({{0.0, -1.0}, {0.6, -0.9}, {0.3, 0.0}, {0.9, 1.0}, {0.0, 1.2}}, 8);
    EXPECT_FALSE(meetsItself(glass));
    for (glm::dvec3& p : glass.positions)
        if (p.y < -0.5) p = {-p.x, p.y, p.z};
    EXPECT_TRUE(meetsItself(glass));
    add(glass);
    EXPECT_EQ(surfaces().count(), 0u);
    add(glass, 1);
    EXPECT_EQ(surfaces().count(), 1u);
}

TEST_F(ClosedSurfacesTest, ATurnedGridOfFlatSidesDoesNotCrossItself) {
    // Coplanar neighbours, all of whose coordinates are rounded.
    Shape turnedBox = box({2.4, 2.4, 2.4}, {18, 30, 20});
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1.0, 0.7, -0.3)),
                     side = glm::normalize(glm::cross(axis, glm::dvec3(0.0, 0.0, 1.0)));
    for (glm::dvec3& p : turnedBox.positions)
        p = glm::dmat3(axis, side, glm::cross(axis, side)) * p + glm::dvec3(12.3, -4.5, 6.7);
    EXPECT_FALSE(meetsItself(turnedBox));
    turnedBox.positions[turnedBox.triangles.front().x] += glm::dvec3(0.0, 5.0, 0.0);
    EXPECT_TRUE(meetsItself(turnedBox));
}

TEST_F(ClosedSurfacesTest, AFanOfManySliversIsGivenUp) {
    const auto cone = [](int sides) { return turned({{0.0, -1.0}, {3.0, 0.0}, {0.0, 1.0}}, sides); };
    add(cone(2000));
    EXPECT_EQ(surfaces().count(), 1u);
    add(cone(120000));
    EXPECT_EQ(surfaces().count(), 1u) << "and this test ends";
}

TEST_F(ClosedSurfacesTest, TakeVerticesOfOneInstanceForOne) {
    Shape split;  // a cube as a file with flat normals has it: no triangle shares a vertex
    for (const glm::u32vec3& t : cube.triangles) {
        const auto first = static_cast<std::uint32_t>(split.positions.size());
        for (int corner = 0; corner < 3; ++corner) split.positions.push_back(cube.positions[t[corner]]);
        split.triangles.emplace_back(first, first + 1, first + 2);
    }
    add(split);
    EXPECT_EQ(pairs(), (std::vector<char>{0, 1}));
    // A seam that opens lets light through.
    const ClosedSurfaces closed = surfaces();
    mesh_.positionsClose[0].x += 1e-9;
    EXPECT_EQ(closed.facingAwayCullable(mesh_, glm::dvec3(0.0), camera_, light_), (std::vector<char>{0, 0}));
}

TEST_F(ClosedSurfacesTest, AreNotCullableAroundAnEye) {
    add(reversed(cube), 1);
    const auto at = [&](const glm::dvec3& eye) {
        camera_.close.eye = eye;
        return pairs().at(1);
    };
    EXPECT_EQ(at({0.0, 0.0, 0.7}), 1);
    EXPECT_EQ(at({0.0, 0.0, 0.63}), 1);
    EXPECT_EQ(at({0.0, 0.0, 0.6}), 0) << "the corners of the near plane";
    EXPECT_EQ(at({0.0, 0.0, 0.0}), 0);
    EXPECT_EQ(at({0.0, 0.0, -5.0}), 0) << "the eye flies through";
    add(cube);
    EXPECT_EQ(pairs(), (std::vector<char>{0, 0, 1})) << "a solid, where the winding number is not negative";
}

TEST_F(ClosedSurfacesTest, AreNotCullableAroundALight) {
    add(cube);
    const auto at = [&](const glm::dvec3& position) {
        light_.close.eye = position;
        return pairs().at(1);
    };
    EXPECT_EQ(at({0.0, 0.52, 0.52}), 1);
    EXPECT_EQ(at({0.0, 0.505, 0.505}), 0) << "its near plane reaches in";
    EXPECT_EQ(at({0.0, 0.0, 0.0}), 0);
    EXPECT_EQ(at({0.0, -6.0, -6.0}), 0) << "the light flies through";
    light_.projection = Projection::Orthographic;  // from without, always
    EXPECT_EQ(at({0.0, 0.0, 0.0}), 1);
}

TEST_F(ClosedSurfacesTest, AreNotCullableWhenMirrored) {
    add(cube);
    const ClosedSurfaces closed = surfaces();
    for (glm::dvec3& p : mesh_.positionsClose) p.x = -p.x;
    EXPECT_EQ(closed.facingAwayCullable(mesh_, glm::dvec3(0.0), camera_, light_), (std::vector<char>{0, 0}))
        << "flat half-way";
    for (glm::dvec3& p : mesh_.positionsOpen) p.x = -p.x;
    EXPECT_EQ(closed.facingAwayCullable(mesh_, glm::dvec3(0.0), camera_, light_), (std::vector<char>{0, 0}))
        << "inside out throughout";
}

TEST_F(ClosedSurfacesTest, ShellsWithinShellsAreSurfacesOfTheirOwn) {
    add(both(geodesicSphere(4), reversed(stretched(geodesicSphere(4), glm::dvec3(0.8)))));
    EXPECT_EQ(surfaces().count(), 1u) << "the inner one faces inwards: a ray that starts between them sees its backs";
}

}  // namespace
}  // namespace timeshade
