#include "scenes/branches.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "scenes/staging.h"

namespace timeshade {

namespace {

/// Two unit vectors that with `along` make a right-handed frame: across, along, out.
glm::dmat3 frameAlong(const glm::dvec3& along) {
    const glm::dvec3 helper = std::abs(along.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 out = glm::normalize(glm::cross(helper, along));
    return {glm::cross(along, out), along, out};
}

glm::dvec3 wayAt(const std::vector<glm::dvec3>& line, std::size_t i) {
    const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, line.size() - 1);
    return glm::normalize(line[after] - line[before]);
}

/// How branches of one order grow, from the trunk (0) to the twigs that bear leaves.
struct Order {
    double length, radius;  ///< radius at its root
    int points, sides, children;
    double firstChild;  ///< share of its length
    double leaving;     ///< degrees between a child and its parent
    double bending;     ///< towards the sky, a piece
};
const Order orders[] = {
    {4.4, 0.30, 9, 16, 12, 0.34, 58.0, 0.02},
    {2.9, 0.105, 8, 9, 10, 0.28, 48.0, 0.075},
    {1.2, 0.042, 6, 6, 0, 0.0, 0.0, 0.05},
};
constexpr double goldenAngle = 2.399963229728653;

class Growth {
  public:
    explicit Growth(std::uint32_t seed) : seed_(seed) {}

    void grow(const glm::dvec3& root, glm::dvec3 way, std::size_t order, double size) {
        const Order& kind = orders[order];
        Dice dice(seed_, number_++);
        std::vector<glm::dvec3> line{root};
        const double piece = size * kind.length / (kind.points - 1);
        for (int i = 1; i < kind.points; ++i) {
            const double wander = order == 0 ? 0.10 : 0.16;
            way = glm::normalize(way + wander * dice.direction() + glm::dvec3(0.0, kind.bending, 0.0));
            line.push_back(line.back() + piece * way);
        }
        const double radius = kind.radius * std::sqrt(size);
        branches_.wood.add(bar(line, radius, 0.28 * radius, kind.sides));
        if (kind.children == 0) return twigs_.push_back(line);
        const double turn = dice.between(0.0, 2.0 * pi);
        for (int child = 0; child < kind.children; ++child) {
            const double share =
                kind.firstChild + (0.97 - kind.firstChild) * (child + dice.between(0.2, 0.8)) / kind.children;
            const double place = share * (kind.points - 1);
            const auto i = static_cast<std::size_t>(place);
            const glm::dvec3 along = wayAt(line, i);
            const glm::dmat3 frame = frameAlong(along);
            const double angle = turn + child * goldenAngle;
            const double leaving = glm::radians(kind.leaving * dice.between(0.8, 1.15) * (1.25 - 0.6 * share));
            const glm::dvec3 out = std::cos(angle) * frame[0] + std::sin(angle) * frame[2];
            // Low branches are the longest, but for the very lowest: the crown is round.
            const double rest = 1.18 - 0.78 * (share - kind.firstChild) / (1.0 - kind.firstChild);
            grow(glm::mix(line[i], line[i + 1], place - static_cast<double>(i)),
                 std::cos(leaving) * along + std::sin(leaving) * out, order + 1, size * rest * dice.between(0.85, 1.1));
        }
    }

    /// Sprays in turn over all twigs, the outer halves first.
    Branches withSprays(int count) {
        for (int i = 0; i < count; ++i) {
            Dice dice(seed_ + 7919u, static_cast<std::uint32_t>(i));
            const std::vector<glm::dvec3>& line = twigs_[static_cast<std::size_t>(i) * 61 % twigs_.size()];
            const double place = dice.between(0.25, 0.999) * static_cast<double>(line.size() - 1);
            const auto piece = static_cast<std::size_t>(place);
            const glm::dvec3 along = wayAt(line, piece);
            const glm::dmat3 frame = frameAlong(along);
            const double angle = dice.between(0.0, 2.0 * pi);
            const glm::dvec3 out = std::cos(angle) * frame[0] + std::sin(angle) * frame[2];
            const glm::dvec3 way = glm::normalize(0.5 * along + out + glm::dvec3(0.0, dice.between(-0.5, 0.35), 0.0));
            branches_.sprays.push_back(
                {glm::mix(line[piece], line[piece + 1], place - static_cast<double>(piece)), frameAlong(way)});
        }
        return std::move(branches_);
    }

  private:
    std::uint32_t seed_;
    std::uint32_t number_ = 0;
    Branches branches_;
    std::vector<std::vector<glm::dvec3>> twigs_;
};

/// From its stalk at `root` along `way`, its upper side to `up`; folded along the rib, its tip hanging.
void addLeaf(Shape& shape, const glm::dvec3& root, const glm::dvec3& way, const glm::dvec3& up, double length) {
    const glm::dvec3 side = glm::cross(way, up);
    const auto at = [&](double along, double across, double high) {
        return root + length * (along * way + across * side + high * up);
    };
    const glm::dvec3 corners[] = {at(0.0, 0.0, 0.0),     at(0.36, 0.0, -0.02), at(0.70, 0.0, -0.07),
                                  at(1.0, 0.0, -0.20),   at(0.24, 0.25, 0.06), at(0.62, 0.24, 0.0),
                                  at(0.24, -0.25, 0.06), at(0.62, -0.24, 0.0)};
    const auto first = static_cast<std::uint32_t>(shape.positions.size());
    for (const glm::dvec3& corner : corners) {
        shape.positions.push_back(corner);
        const double across = glm::dot(corner - root, side) / length;
        shape.normals.emplace_back(glm::normalize(up + 0.35 * way - 0.5 * across * side));
    }
    constexpr std::uint32_t left[][3] = {{0, 4, 1}, {1, 4, 2}, {4, 5, 2}, {5, 3, 2}};
    for (const auto& t : left) shape.triangles.emplace_back(first + t[0], first + t[2], first + t[1]);
    for (const auto& t : left) {
        const auto mirrored = [](std::uint32_t corner) { return corner >= 4 ? corner + 2 : corner; };
        shape.triangles.emplace_back(first + mirrored(t[0]), first + mirrored(t[1]), first + mirrored(t[2]));
    }
}

}  // namespace

Shape bar(const std::vector<glm::dvec3>& line, double firstRadius, double lastRadius, int sides) {
    CHECK_GE(line.size(), 2);
    CHECK_GE(sides, 3);
    Shape shape;
    glm::dmat3 frame = frameAlong(wayAt(line, 0));
    const auto count = static_cast<std::uint32_t>(sides);
    for (std::size_t i = 0; i < line.size(); ++i) {
        // The frame is carried along, so that the bar does not twist.
        const glm::dvec3 along = wayAt(line, i);
        const glm::dvec3 out = glm::normalize(frame[2] - glm::dot(frame[2], along) * along);
        frame = {glm::cross(along, out), along, out};
        const double share = static_cast<double>(i) / static_cast<double>(line.size() - 1);
        const double radius = glm::mix(firstRadius, lastRadius, share);
        for (std::uint32_t k = 0; k < count; ++k) {
            const double angle = 2.0 * pi * k / sides;
            const glm::dvec3 normal = std::cos(angle) * frame[2] + std::sin(angle) * frame[0];
            shape.positions.push_back(line[i] + radius * normal);
            shape.normals.emplace_back(normal);
        }
        for (std::uint32_t k = 0; i > 0 && k < count; ++k) {
            const auto below = static_cast<std::uint32_t>(i - 1) * count, above = below + count;
            const std::uint32_t next = (k + 1) % count;
            shape.triangles.emplace_back(below + k, below + next, above + next);
            shape.triangles.emplace_back(below + k, above + next, above + k);
        }
    }
    for (const bool last : {false, true}) {
        const glm::dvec3 along = wayAt(line, last ? line.size() - 1 : 0) * (last ? 1.0 : -1.0);
        const auto tip = static_cast<std::uint32_t>(shape.positions.size());
        shape.positions.push_back((last ? line.back() : line.front()) + along * (last ? lastRadius : firstRadius));
        shape.normals.emplace_back(along);
        const std::uint32_t ring = last ? static_cast<std::uint32_t>(line.size() - 1) * count : 0;
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t next = (k + 1) % count;
            shape.triangles.emplace_back(ring + (last ? k : next), ring + (last ? next : k), tip);
        }
    }
    return shape;
}

Branches grownBranches(std::uint32_t seed, int sprays) {
    Growth growth(seed);
    growth.grow({0.0, -0.15, 0.0}, {0.0, 1.0, 0.0}, 0, 1.0);
    return growth.withSprays(sprays);
}

Shape sprayOfLeaves(std::uint32_t seed) {
    Shape shape;
    constexpr int leaves = 14;
    for (int i = 0; i < leaves; ++i) {
        Dice dice(seed, static_cast<std::uint32_t>(i));
        const double share = (i + 0.6) / leaves, angle = i * goldenAngle + dice.between(-0.4, 0.4);
        const glm::dvec3 root(0.012 * std::cos(angle), 0.55 * share, 0.012 * std::sin(angle));
        const glm::dvec3 out(std::cos(angle), 0.0, std::sin(angle));
        const double rise = dice.between(0.25, 0.9) + 0.5 * share;
        const glm::dvec3 way = glm::normalize(out + glm::dvec3(0.0, rise, 0.0));
        const glm::dvec3 side = glm::normalize(glm::cross(way, glm::dvec3(0.0, 1.0, 0.0)));
        addLeaf(shape, root, way, glm::cross(side, way), dice.between(0.16, 0.24) * (1.1 - 0.3 * share));
    }
    return shape;
}

}  // namespace timeshade
