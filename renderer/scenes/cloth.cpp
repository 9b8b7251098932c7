#include "scenes/cloth.h"

#include <cmath>

#include "scenes/staging.h"

namespace timeshade {

namespace {

/// Where a point of the cloth is, by its share of width and of height, from the rod's middle.
glm::dvec3 pointOf(const Cloth& cloth, double across, double down, double time, double size) {
    const double turn = 2.0 * pi * (cloth.waves * time / cloth.period + cloth.phase);
    const double free = down * down * (3.0 - 2.0 * down) * 0.6 + 0.4 * down;
    const double wave = 0.55 * std::sin(turn - 5.2 * down + 2.6 * across) +
                        0.30 * std::sin(2.0 * turn - 8.5 * down - 4.0 * across) + 0.45 * std::sin(turn - 1.1 * down);
    // Folds that hang down from the rod.
    const double folds = 0.035 * std::sin(8.0 * pi * across) * (0.35 + 0.65 * down);
    return {(across - 0.5) * cloth.width * (1.0 - 0.05 * down), -down * cloth.height + 0.25 * size * free * wave * wave,
            size * free * (wave + 0.35) + folds};
}

class Waving final : public Flesh {
  public:
    explicit Waving(const Cloth& cloth) : cloth_(cloth) {}

    void bend(double seconds, const std::vector<std::uint32_t>& vertices, glm::dvec3* positions,
              glm::vec3* normals) const override {
        constexpr double step = 1e-4;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const auto columns = static_cast<std::uint32_t>(cloth_.columns + 1);
            const double across = static_cast<double>(vertices[i] % columns) / cloth_.columns;
            const double down = static_cast<double>(vertices[i] / columns) / cloth_.rows;
            const auto at = [&](double x, double y) { return pointOf(cloth_, x, y, seconds, cloth_.size); };
            positions[i] = cloth_.place.of(at(across, down));
            if (normals == nullptr) continue;
            const glm::dvec3 alongWidth = at(across + step, down) - at(across - step, down);
            const glm::dvec3 alongHeight = at(across, down - step) - at(across, down + step);
            normals[i] = glm::normalize(cloth_.place.axes * glm::cross(alongWidth, alongHeight));
        }
    }
    /// It bends, but no part of it is turned by more than a wave tilts it.
    double turn(double fromSeconds, double toSeconds) const override {
        const auto slopeAt = [&](double seconds) {
            const glm::dvec3 end = pointOf(cloth_, 0.5, 1.0, seconds, cloth_.size),
                             before = pointOf(cloth_, 0.5, 0.9, seconds, cloth_.size);
            return glm::degrees(std::atan2(end.z - before.z, before.y - end.y));
        };
        return std::abs(slopeAt(toSeconds) - slopeAt(fromSeconds));
    }

  private:
    Cloth cloth_;
};

}  // namespace

std::shared_ptr<const Shape> hangingCloth(const Cloth& cloth) {
    Shape shape;
    for (int row = 0; row <= cloth.rows; ++row)
        for (int column = 0; column <= cloth.columns; ++column) {
            const double across = static_cast<double>(column) / cloth.columns,
                         down = static_cast<double>(row) / cloth.rows;
            shape.positions.push_back(cloth.place.of(pointOf(cloth, across, down, 0.0, 0.0)));
            shape.normals.emplace_back(cloth.place.axes[2]);
        }
    const auto columns = static_cast<std::uint32_t>(cloth.columns + 1);
    for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(cloth.rows); ++row)
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t a = row * columns + column, b = a + 1, c = a + columns, d = c + 1;
            shape.triangles.emplace_back(a, c, d);
            shape.triangles.emplace_back(a, d, b);
        }
    return std::make_shared<const Shape>(std::move(shape));
}

std::shared_ptr<const Flesh> wavingCloth(const Cloth& cloth) { return std::make_shared<const Waving>(cloth); }

}  // namespace timeshade
