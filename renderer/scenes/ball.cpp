#include "scenes/ball.h"

#include <algorithm>
#include <cmath>

#include "scenes/staging.h"

namespace timeshade {

namespace {

constexpr double framesPerSecond = 24.0;
constexpr double groundSide = 30.0;
const glm::dvec3 pivot(0.0, 9.2, 0.0);
constexpr double ropeLength = 6.6;  // from the pivot to the ball's centre
constexpr double ballRadius = 1.15;
constexpr double firstAngle = -0.95, lastAngle = 0.62;  // of the rope; 0 hangs down
const glm::dvec3 blockSize(0.55, 0.5, 0.95);
constexpr int blocksPerCourse = 14;
constexpr double reach = 2.5;  // of the blow, from its centre

/// The rope's angle at a share of the swing, and the share at which the ball touches the wall.
double angleAt(double share) { return firstAngle + (lastAngle - firstAngle) * share; }
double shareOfBlow() {
    const double touching = -std::asin((ballRadius + 0.5 * blockSize.x) / ropeLength);
    return (touching - firstAngle) / (lastAngle - firstAngle);
}

glm::dvec3 ballPlace(double share) {
    const double angle = angleAt(share);
    return pivot + ropeLength * glm::dvec3(std::sin(angle), -std::cos(angle), 0.0);
}

/// How a struck block flies; still for one out of the ball's reach.
struct Flight {
    glm::dvec3 velocity{0.0};  ///< units in a whole swing
    double fall = 0.0;         ///< units in the square of that
    glm::dvec3 axis{1.0, 0.0, 0.0};
    double spin = 0.0;  ///< radians in a whole swing

    RigidPose after(const glm::dvec3& place, double time) const {
        return {place + velocity * time - glm::dvec3(0.0, fall * time * time, 0.0), turnAbout(axis, spin * time)};
    }
};

Flight flightOf(const glm::dvec3& place, std::uint32_t number) {
    const glm::dvec3 blow = ballPlace(shareOfBlow());
    const double away = glm::length(glm::dvec2(place.y - blow.y, place.z));
    if (away >= reach) return {};
    Dice dice(1, number);
    const double force = 1.0 - away / reach, arc = ropeLength * (lastAngle - firstAngle);
    Flight flight;
    flight.velocity = {arc * (0.25 + 1.1 * std::sqrt(force)) * dice.between(0.9, 1.1), 3.0 * (place.y - blow.y) + 2.0,
                       2.6 * place.z + dice.between(-1.0, 1.0)};
    const double most = 1.0 - shareOfBlow();
    const double room = place.y + flight.velocity.y * most - 0.7;  // so that none falls through the ground
    flight.fall = std::min(9.0, room / (most * most));
    flight.axis = dice.direction();
    flight.spin = dice.between(1.5, 4.0);
    return flight;
}

void addWall(SceneParts& parts, int courses, const std::function<double(double)>& shareAt) {
    const auto block = std::make_shared<const Shape>(box(blockSize - glm::dvec3(0.02), {1, 1, 1}));
    for (int course = 0; course < courses; ++course)
        for (int i = 0; i < blocksPerCourse; ++i) {
            const double shift = course % 2 == 0 ? 0.25 : -0.25;
            const glm::dvec3 place(0.0, (course + 0.5) * blockSize.y + 0.02,
                                   (i - 0.5 * (blocksPerCourse - 1) + shift) * blockSize.z);
            const Flight flight = flightOf(place, static_cast<std::uint32_t>(course * blocksPerCourse + i));
            MeshInstance instance;
            instance.shape = block;
            instance.material = 1 + static_cast<std::uint32_t>((7 * course + 3 * i) % 3);
            instance.pose = {place, glm::dmat3(1.0)};
            if (flight.spin > 0.0 && shareAt)
                instance.motion = [=](double seconds) {
                    return flight.after(place, std::max(0.0, shareAt(seconds) - shareOfBlow()));
                };
            parts.instances.push_back(std::move(instance));
        }
}

void addBall(SceneParts& parts, const std::function<double(double)>& shareAt) {
    const auto at = [](double share, double along) {
        const glm::dmat3 turn = turnAbout({0.0, 0.0, 1.0}, angleAt(share));
        return RigidPose{pivot + turn * glm::dvec3(0.0, -along, 0.0), turn};
    };
    const auto add = [&](Shape shape, double along, std::uint32_t material) {
        MeshInstance instance;
        instance.shape = std::make_shared<const Shape>(std::move(shape));
        instance.material = material;
        instance.pose = at(shareOfBlow(), along);
        if (shareAt) instance.motion = [=](double seconds) { return at(shareAt(seconds), along); };
        parts.instances.push_back(std::move(instance));
    };
    add(stretched(geodesicSphere(17), glm::dvec3(ballRadius)), ropeLength, 4);
    add(box({0.1, ropeLength - ballRadius, 0.1}, {1, 1, 1}), 0.5 * (ropeLength - ballRadius), 4);
}

}  // namespace

const RecipeDescription& Ball::description() const {
    static const RecipeDescription description{
        "ball", "a heavy ball swings into a wall of blocks, which fly off, turning: 8,000 triangles"};
    return description;
}

void Ball::visitSettings(SettingsVisitor& visitor) {
    visitor.number("speed", speed_, 0.45, 0.0, 2.0, "units per frame",
                   "About how far the ball swings in one frame; its radius is 1.15.");
    visitor.whole("courses", courses_, 12, 1, 16, "courses", "How high the wall is; 14 blocks each.");
}

std::unique_ptr<Scene> Ball::make() {
    SceneParts parts;
    parts.name = description().name;
    parts.parameters = parametersOf(*this);
    const double arc = ropeLength * (lastAngle - firstAngle);
    const double there = speed_ > 0.0f ? std::max(2.0, std::round(arc / static_cast<double>(speed_))) : 0.0;
    std::function<double(double)> shareAt;
    if (there > 0.0) shareAt = [=](double seconds) { return backAndForth(seconds * framesPerSecond / (2.0 * there)); };
    // A fifth of the swing behind the blow.
    parts.defaults = {std::floor((shareOfBlow() + 0.2) * there), framesPerSecond, 1.0};
    parts.duration = 2.0 * there / framesPerSecond;
    parts.materials = {matt("ground", {0.44f, 0.43f, 0.40f}, 0.95f), matt("brick", {0.62f, 0.28f, 0.17f}),
                       matt("clay", {0.72f, 0.38f, 0.24f}), matt("rust", {0.52f, 0.22f, 0.14f}),
                       matt("iron", {0.13f, 0.14f, 0.16f}, 0.45f)};
    parts.instances.push_back(ground(groundSide, 0));
    addWall(parts, courses_, shareAt);
    addBall(parts, shareAt);
    parts.cameras.emplace_back("beside", staticCamera({13.5, 7.5, 11.0}, {1.2, 2.5, 0.0}, 0.60));
    parts.cameras.emplace_back("behind", staticCamera({-13.0, 6.5, 9.0}, {0.0, 2.8, 0.0}, 0.60));
    parts.light = staticSpot({9.0, 16.0, 11.0}, {1.2, 2.0, 0.0}, 0.52, 0.60);
    parts.bounds.add(glm::dvec3(-0.5 * groundSide, 0.0, -0.5 * groundSide));
    parts.bounds.add(glm::dvec3(0.5 * groundSide, 14.0, 0.5 * groundSide));
    return std::make_unique<MeshScene>(std::move(parts));
}

}  // namespace timeshade
