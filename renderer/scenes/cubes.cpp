#include "scenes/cubes.h"

#include <algorithm>
#include <cmath>

#include "scenes/staging.h"

namespace timeshade {

namespace {

constexpr int frames = 240;
constexpr double framesPerSecond = 24.0;
constexpr double groundSide = 44.0;

/// The volume that contains the cubes' centres.
const glm::dvec3 airLow(-9.0, 1.2, -9.0), airHigh(9.0, 10.6, 9.0);

const glm::vec3 colours[] = {{0.82f, 0.33f, 0.22f}, {0.90f, 0.62f, 0.22f}, {0.86f, 0.82f, 0.72f},
                             {0.28f, 0.52f, 0.62f}, {0.20f, 0.34f, 0.52f}, {0.55f, 0.64f, 0.42f}};

struct Flight {
    glm::dvec3 centre, across, up;  ///< of the circle: its centre and two unit vectors of its plane
    Circle circle;
    double phase = 0.0;  ///< radians
    glm::dmat3 axes{1.0};
    glm::dvec3 turnAxis{0.0, 1.0, 0.0};
    int turns = 0;

    RigidPose at(double seconds) const {
        const double round = 2.0 * pi * seconds * framesPerSecond / frames;
        const double angle = phase + round * circle.rounds;
        return {centre + circle.radius * (std::cos(angle) * across + std::sin(angle) * up),
                turnAbout(turnAxis, round * turns) * axes};
    }
};

/// way: how far the fastest fly in a frame.
Flight flightOf(std::uint32_t seed, std::uint32_t cube, double way, double degreesPerFrame) {
    Dice dice(seed, cube);
    Flight flight;
    const glm::dvec3 normal = dice.direction();
    flight.across = glm::normalize(
        glm::cross(std::abs(normal.y) < 0.8 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0), normal));
    flight.up = glm::cross(normal, flight.across);
    const double chord = way * dice.between(0.5, 1.0);
    flight.circle = Circle::withChord(chord, std::max(dice.between(2.0, 3.2), 0.55 * chord), frames);
    for (int axis = 0; axis < 3; ++axis) {
        const double reach = flight.circle.radius * std::sqrt(std::max(0.0, 1.0 - normal[axis] * normal[axis]));
        flight.centre[axis] = dice.between(airLow[axis] + reach, airHigh[axis] - reach);
    }
    flight.phase = dice.between(0.0, 2.0 * pi);
    flight.axes = turnAbout(dice.direction(), dice.between(0.0, 2.0 * pi));
    flight.turnAxis = dice.direction();
    flight.turns = static_cast<int>(std::lround(degreesPerFrame * dice.between(0.5, 1.0) * frames / 360.0));
    return flight;
}

}  // namespace

const RecipeDescription& Cubes::description() const {
    static const RecipeDescription description{
        "cubes", "many cubes in the air, each flying and turning in its own way, and their shadows on the ground"};
    return description;
}

void Cubes::visitSettings(SettingsVisitor& visitor) {
    visitor.whole("count", count_, 500.0, 1.0, 25000.0, "cubes", "How many cubes fly; 12 triangles each.", true);
    visitor.number("speed", speed_, 2.0, 0.0, 16.0, "cube sizes per frame",
                   "How far the fastest cubes fly in one frame; the slowest fly half as far.");
    visitor.number(
        "turn", turn_, 6.0, 0.0, 30.0, "degrees per frame",
        "How far the cubes that turn fastest turn in one frame, to a step of 1.5; the slowest turn half as far.");
    // The widest circle that the fastest need fits into the air.
    visitor.number("size", size_, 0.4, 0.02, 0.5, "units", "The side of a cube; they fly in a block of 18 x 9.4 x 18.");
    visitor.whole("seed", seed_, 1.0, 0.0, 1e6, "seed", "Another number is another flight of all cubes.");
}

std::unique_ptr<Scene> Cubes::make() {
    SceneParts parts;
    parts.name = description().name;
    parts.defaults = {0.0, framesPerSecond, 1.0};
    parts.parameters = parametersOf(*this);
    parts.materials.push_back(matt("ground", {0.44f, 0.43f, 0.40f}, 0.95f));
    for (const glm::vec3& colour : colours) parts.materials.push_back(matt("cube", colour, 0.6f));
    parts.instances.push_back(ground(groundSide, 0));
    const double side = std::round(1e6 * static_cast<double>(size_)) / 1e6;  // 0.4 is no float
    const auto cube = std::make_shared<const Shape>(box(glm::dvec3(side), glm::ivec3(1)));
    for (int i = 0; i < count_; ++i) {
        const auto number = static_cast<std::uint32_t>(i);
        const Flight flight = flightOf(static_cast<std::uint32_t>(seed_), number, side * static_cast<double>(speed_),
                                       static_cast<double>(turn_));
        MeshInstance instance;
        instance.shape = cube;
        instance.material = 1 + number % static_cast<std::uint32_t>(std::size(colours));
        if (flight.circle.rounds > 0 || flight.turns > 0) {
            instance.motion = [flight](double seconds) { return flight.at(seconds); };
            parts.duration = frames / framesPerSecond;
        } else {
            instance.pose = flight.at(0.0);
        }
        parts.instances.push_back(std::move(instance));
    }
    parts.cameras.emplace_back("block", staticCamera({12.0, 14.6, 23.0}, {0.0, 4.0, 0.0}, 0.62));
    parts.cameras.emplace_back("above", staticCamera({2.0, 36.0, 8.0}, {0.0, 2.0, -0.5}, 0.62));
    parts.light = staticSpot({-9.0, 31.0, 7.0}, {0.0, 3.5, 0.0}, 0.47, 0.56);
    parts.bounds.add(glm::dvec3(-0.5 * groundSide, 0.0, -0.5 * groundSide));
    parts.bounds.add(glm::dvec3(0.5 * groundSide, airHigh.y + side, 0.5 * groundSide));
    return std::make_unique<MeshScene>(std::move(parts));
}

}  // namespace timeshade
