#include "options/light_options.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "core/error.h"
#include "options/number_list.h"
#include "options/option_checks.h"

namespace timeshade {

namespace {

constexpr double farthest = 1e9;       // world units
constexpr double strongest = 1e6;      // times the scene's own
constexpr double fastestTurn = 360.0;  // degrees a frame

bool within(double value, double most) { return std::abs(value) <= most; }

LightDirection readDirection(const std::string& text) {
    const auto numbers = numbersIn<double>(text);
    const std::size_t count = numbers ? numbers->size() : 0;
    if (count == 2 && within((*numbers)[0], 360.0) && within((*numbers)[1], 90.0))
        return {(*numbers)[0], (*numbers)[1]};
    if (count == 3) {
        const glm::dvec3 towards((*numbers)[0], (*numbers)[1], (*numbers)[2]);
        const double length = glm::length(towards);
        if (length > 1e-9 && length <= farthest) return directionOf(towards);
    }
    throw UsageError(fmt::format(
        "--light-direction {}: expected AZIMUTH,ELEVATION in degrees (azimuth -360 to 360, elevation -90 to 90), or "
        "X,Y,Z towards the light, not all 0",
        text));
}

glm::dvec3 readMove(const std::string& text) {
    const auto numbers = numbersIn<double>(text, 3);
    if (!numbers || !std::all_of(numbers->begin(), numbers->end(), [](double n) { return within(n, farthest); }))
        throw UsageError(
            fmt::format("--light-move {}: expected X,Y,Z in world units a frame, each from -1e9 to 1e9", text));
    return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

void readTurn(const std::string& text, LightChange& light) {
    const auto numbers = numbersIn<double>(text);
    const std::size_t count = numbers ? numbers->size() : 0;
    if ((count != 1 && count != 2) ||
        !std::all_of(numbers->begin(), numbers->end(), [](double n) { return within(n, fastestTurn); }))
        throw UsageError(
            fmt::format("--light-turn {}: expected TURN or TURN,RISE in degrees a frame, each from -360 to 360", text));
    light.turn = numbers->front();
    light.rise = count == 2 ? numbers->back() : 0.0;
}

/// An option that a function reads. The last one counts.
template <typename Read>
void readWith(CLI::App& app, const char* name, const char* expected, Read read, const char* help) {
    app.add_option_function<std::string>(name, read, help)->check(notEmpty(expected))->multi_option_policy(lastWins);
}

}  // namespace

void declareLight(CLI::App& app, FrameOptions& options) {
    app.option_defaults()->group("Light, ground and display");
    app.add_option(
           "--light", options.lightName,
           "which of the file's lights: its name, or its number from 1; fitted: one that is fitted to the scene")
        ->check(notEmpty("a light's name or number, or fitted"))
        ->multi_option_policy(lastWins);
    LightChange& light = options.light;
    readWith(
        app, "--light-direction", "AZIMUTH,ELEVATION or X,Y,Z",
        [&light](const std::string& text) { light.direction = readDirection(text); },
        "where the light comes from, seen from the scene's centre: AZIMUTH,ELEVATION in degrees (azimuth 0 along +z, "
        "90 "
        "along +x), or X,Y,Z towards it");
    app.add_option("--light-distance", light.distance, "of a spot light from the scene's centre, in world units")
        ->check(numberFrom(1e-9, farthest))
        ->multi_option_policy(lastWins);
    app.add_option("--light-cone", light.cone, "of a spot light: degrees from its axis to its edge")
        ->check(numberFrom(LightChange::leastCone, LightChange::mostCone))
        ->multi_option_policy(lastWins);
    app.add_option("--light-intensity", light.intensity, "times the scene's own (default: 1)")
        ->check(numberFrom(0.0, strongest))
        ->multi_option_policy(lastWins);
    readWith(
        app, "--light-move", "X,Y,Z", [&light](const std::string& text) { light.move = readMove(text); },
        "X,Y,Z: a spot light moves by so many world units a frame, from where it is at the scene's own frame");
    readWith(
        app, "--light-turn", "TURN or TURN,RISE", [&light](const std::string& text) { readTurn(text, light); },
        "TURN or TURN,RISE: the light's direction turns about the vertical, and rises, by so many degrees a frame");
}

void declareGround(CLI::App& app, FrameOptions& options) {
    addChoice<GroundChoice>(
        app, "--ground", options.ground.choice,
        {{"auto", GroundChoice::Auto}, {"on", GroundChoice::On}, {"off", GroundChoice::Off}},
        "auto, on, off: a square of ground below the things of a file; auto where no surface of the file "
        "lies below them");
    app.add_option("--ground-height", options.ground.height,
                   "of the ground, in world units (default: the lowest point over the clip)")
        ->check(numberFrom(-farthest, farthest))
        ->multi_option_policy(lastWins);
    app.add_option("--ground-size", options.ground.size,
                   "side of the ground, in world units (default: so large that the shadow lies on it)")
        ->check(numberFrom(1e-9, farthest))
        ->multi_option_policy(lastWins);
}

void declareLook(CLI::App& app, FrameOptions& options) {
    app.add_option("--exposure", options.look.exposure,
                   "stops above the scene's own exposure, of what is shown (not of .exr files)")
        ->check(numberFrom(DisplayLook::leastExposure, DisplayLook::mostExposure))
        ->capture_default_str()
        ->multi_option_policy(lastWins);
    addChoice<ToneMap>(app, "--tone-map", options.look.toneMap,
                       {{"filmic", ToneMap::Filmic}, {"reinhard", ToneMap::Reinhard}, {"linear", ToneMap::Linear}},
                       "filmic, reinhard, linear: how radiance becomes a picture");
}

void requireLightHas(const LightPose& light, const LightChange& change, const std::string& scene) {
    if (light.kind == LightKind::Spot) return;
    const auto refuse = [&](const char* option, const std::string& value, const char* what) {
        throw UsageError(
            fmt::format("{} {}: the light of {} is a sun, which has no {}; expected --light-direction or --light-turn",
                        option, value, scene, what));
    };
    if (change.distance) refuse("--light-distance", fmt::format("{}", *change.distance), "place");
    if (change.cone) refuse("--light-cone", fmt::format("{}", *change.cone), "cone");
    if (change.move != glm::dvec3(0.0))
        refuse("--light-move", fmt::format("{},{},{}", change.move.x, change.move.y, change.move.z), "place");
}

}  // namespace timeshade
