#include "scenes/leg.h"

#include <cmath>

#include "scenes/run_cycle.h"
#include "scenes/skinned_runner.h"
#include "scenes/staging.h"

namespace timeshade {

namespace {

constexpr double framesPerSecond = 24.0;
constexpr double groundSide = 30.0;
constexpr double shownStride = 0.74;  ///< the left leg swings forwards

}  // namespace

const RecipeDescription& Leg::description() const {
    static const RecipeDescription description{
        "leg", "a leg that swings towards the light: a skinned runner of 265,000 triangles"};
    return description;
}

void Leg::visitSettings(SettingsVisitor& visitor) {
    visitor.number("cell", cell_, 4.6, 4.0, 20.0, "mm",
                   "About how large the body's triangles are; their number falls with its square.");
    visitor.whole("pace", pace_, 24, 8, 48, "frames", "In how many frames the runner makes two steps.");
}

std::unique_ptr<Scene> Leg::make() {
    SceneParts parts;
    parts.name = description().name;
    parts.parameters = parametersOf(*this);
    const auto [radius, strides] = roundTrack(4.0);
    const Track track{radius};
    const double pace = pace_ / framesPerSecond;
    parts.duration = strides * pace;
    parts.defaults = {std::floor(shownStride * pace_), framesPerSecond, 1.0};
    parts.materials = {matt("track", {0.36f, 0.17f, 0.11f}, 0.95f), matt("runner", glm::vec3(1.0f), 0.6f)};
    parts.instances.push_back(ground(groundSide, 0));
    parts.instances.push_back(skinnedRunner(0.001 * static_cast<double>(cell_), pace, track, 1));
    const double along = shownStride * strideLength;
    const glm::dmat3 heading = track.heading(along);
    const glm::dvec3 here = track.at(along, 0.0);
    // Left, up and forwards of where the runner is.
    const auto beside = [&](const glm::dvec3& offset) { return here + heading * offset; };
    parts.cameras.emplace_back("leg", staticCamera(beside({1.35, 0.80, 1.85}), beside({-0.08, 0.40, 0.02}), 0.50));
    parts.cameras.emplace_back("runner", staticCamera(beside({2.6, 1.5, 4.2}), beside({0.0, 0.85, -0.2}), 0.52));
    parts.light = staticSpot(beside({1.9, 4.0, 5.4}), beside({0.0, 0.5, -0.6}), 0.50, 0.62);
    parts.bounds.add(glm::dvec3(-0.5 * groundSide, -0.1, -0.5 * groundSide));
    parts.bounds.add(glm::dvec3(0.5 * groundSide, 2.2, 0.5 * groundSide));
    return std::make_unique<MeshScene>(std::move(parts));
}

}  // namespace timeshade
