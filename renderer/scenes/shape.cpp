#include "scenes/shape.h"

#include <array>
#include <cmath>
#include <map>

#include "core/check.h"

namespace timeshade {

namespace {

constexpr double pi = 3.14159265358979323846;

/// Adds the grid of one side of a box. Grid points are computed from integers, so that two sides agree on their edge.
void addSide(Shape& shape, const glm::dvec3& size, const glm::ivec3& cells, int axis, bool high) {
    const int across = (axis + 1) % 3, up = (axis + 2) % 3;
    CHECK_GE(cells[across], 1);
    CHECK_GE(cells[up], 1);
    const auto first = static_cast<std::uint32_t>(shape.positions.size());
    glm::vec3 normal(0.0f);
    normal[axis] = high ? 1.0f : -1.0f;
    for (int j = 0; j <= cells[up]; ++j) {
        for (int i = 0; i <= cells[across]; ++i) {
            glm::dvec3 position;
            position[axis] = (high ? 0.5 : -0.5) * size[axis];
            position[across] = (static_cast<double>(i) / cells[across] - 0.5) * size[across];
            position[up] = (static_cast<double>(j) / cells[up] - 0.5) * size[up];
            shape.positions.push_back(position);
            shape.normals.push_back(normal);
        }
    }
    const auto stride = static_cast<std::uint32_t>(cells[across] + 1);
    for (int j = 0; j < cells[up]; ++j) {
        for (int i = 0; i < cells[across]; ++i) {
            const std::uint32_t a = first + static_cast<std::uint32_t>(j) * stride + static_cast<std::uint32_t>(i);
            const std::uint32_t b = a + 1, c = a + stride + 1, d = a + stride;
            shape.triangles.emplace_back(a, high ? b : c, high ? c : b);
            shape.triangles.emplace_back(a, high ? c : d, high ? d : c);
        }
    }
}

/// Numbers the grid points of the icosahedron's sides; points on shared edges get one number.
class GeodesicGrid {
  public:
    explicit GeodesicGrid(int frequency) : frequency_(frequency) {}

    /// The point with these barycentric coordinates times frequency in the side's three corners.
    std::uint32_t point(const std::array<glm::dvec3, 12>& corners, const glm::ivec3& side, const glm::ivec3& shares) {
        std::map<int, int> key;  // corner -> share: equal for both sides of an edge
        for (int i = 0; i < 3; ++i)
            if (shares[i] > 0) key[side[i]] = shares[i];
        const auto [found, isNew] = numbers_.try_emplace(key, static_cast<std::uint32_t>(shape.positions.size()));
        if (isNew) {
            glm::dvec3 position(0.0);
            for (const auto& [corner, share] : key)
                position += (static_cast<double>(share) / frequency_) * corners[static_cast<std::size_t>(corner)];
            shape.positions.push_back(glm::normalize(position));
            shape.normals.emplace_back(shape.positions.back());
        }
        return found->second;
    }

    Shape shape;

  private:
    int frequency_;
    std::map<std::map<int, int>, std::uint32_t> numbers_;
};

}  // namespace

void Shape::add(const Shape& other) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), other.positions.begin(), other.positions.end());
    normals.insert(normals.end(), other.normals.begin(), other.normals.end());
    for (const glm::u32vec3& triangle : other.triangles) triangles.push_back(triangle + first);
    if (!colours.empty() || !other.colours.empty()) {
        colours.resize(first, glm::vec3(1.0f));
        colours.insert(colours.end(), other.colours.begin(), other.colours.end());
        colours.resize(positions.size(), glm::vec3(1.0f));
    }
    if (textureCoordinates.empty() && other.textureCoordinates.empty()) return;
    textureCoordinates.resize(first);
    textureCoordinates.insert(textureCoordinates.end(), other.textureCoordinates.begin(),
                              other.textureCoordinates.end());
    textureCoordinates.resize(positions.size());
}

Shape plane(double width, double depth, int cells) {
    Shape shape;
    addSide(shape, {width, 0.0, depth}, glm::ivec3(cells), 1, true);
    for (const glm::dvec3& p : shape.positions)
        shape.textureCoordinates.emplace_back(p.x / width + 0.5, p.z / depth + 0.5);
    return shape;
}

Shape box(const glm::dvec3& size, const glm::ivec3& cells) {
    Shape shape;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true}) addSide(shape, size, cells, axis, high);
    return shape;
}

Shape geodesicSphere(int frequency) {
    CHECK_GE(frequency, 1);
    const double g = 0.5 * (1.0 + std::sqrt(5.0));
    const std::array<glm::dvec3, 12> corners{{{-1, g, 0},
                                              {1, g, 0},
                                              {-1, -g, 0},
                                              {1, -g, 0},
                                              {0, -1, g},
                                              {0, 1, g},
                                              {0, -1, -g},
                                              {0, 1, -g},
                                              {g, 0, -1},
                                              {g, 0, 1},
                                              {-g, 0, -1},
                                              {-g, 0, 1}}};
    constexpr std::array<std::array<int, 3>, 20> sides{{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                                        {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                                        {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                                        {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
    GeodesicGrid grid(frequency);
    for (const auto& corner : sides) {
        const glm::ivec3 side(corner[0], corner[1], corner[2]);
        const auto at = [&](int i, int j) { return grid.point(corners, side, {frequency - i - j, i, j}); };
        for (int i = 0; i < frequency; ++i) {
            for (int j = 0; j < frequency - i; ++j) {
                grid.shape.triangles.emplace_back(at(i, j), at(i + 1, j), at(i, j + 1));
                if (i + j + 1 < frequency)
                    grid.shape.triangles.emplace_back(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            }
        }
    }
    return std::move(grid.shape);
}

Shape stretched(Shape shape, const glm::dvec3& factors) {
    CHECK(glm::all(glm::greaterThan(factors, glm::dvec3(0.0))));
    for (glm::dvec3& position : shape.positions) position *= factors;
    for (glm::vec3& normal : shape.normals) normal = glm::normalize(normal / glm::vec3(factors));
    return shape;
}

Shape turned(const std::vector<std::pair<double, double>>& profile, int sides) {
    CHECK_GE(profile.size(), 3);
    CHECK_GE(sides, 3);
    CHECK_EQ(profile.front().first, 0.0);
    CHECK_EQ(profile.back().first, 0.0);
    Shape shape;
    const auto ring = [&](double radius, double height, const glm::dvec2& slope) {
        const auto first = static_cast<std::uint32_t>(shape.positions.size());
        for (int i = 0; i < sides; ++i) {
            const double angle = 2.0 * pi * i / sides, c = std::cos(angle), s = std::sin(angle);
            shape.positions.emplace_back(radius * c, height, radius * s);
            shape.normals.emplace_back(glm::normalize(glm::dvec3(slope.x * c, slope.y, slope.x * s)));
        }
        return first;
    };
    for (std::size_t band = 0; band + 1 < profile.size(); ++band) {
        const auto [lowRadius, low] = profile[band];
        const auto [highRadius, high] = profile[band + 1];
        const glm::dvec2 slope(high - low, lowRadius - highRadius);  // the profile's normal
        const std::uint32_t below = ring(lowRadius, low, slope), above = ring(highRadius, high, slope);
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(sides); ++i) {
            const std::uint32_t next = (i + 1) % static_cast<std::uint32_t>(sides);
            if (highRadius > 0.0) shape.triangles.emplace_back(below + i, above + i, above + next);
            if (lowRadius > 0.0) shape.triangles.emplace_back(below + i, above + next, below + next);
        }
    }
    return shape;
}

}  // namespace timeshade
