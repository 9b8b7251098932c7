#include "scenes/runner.h"

#include <cmath>

#include "scenes/cloth.h"
#include "scenes/run_cycle.h"
#include "scenes/skinned_runner.h"
#include "scenes/staging.h"

namespace timeshade {

namespace {

constexpr double framesPerSecond = 24.0;
constexpr double groundSide = 40.0;
constexpr double columnHeight = 3.4;
constexpr int outerColumns = 16, innerColumns = 10;
constexpr double shownStride = 1.74;

/// A column with base and capital, slightly thinner above.
Shape column(double radius, int sides) {
    std::vector<std::pair<double, double>> profile{{0.0, 0.0},   {1.55, 0.0},  {1.55, 0.12}, {1.42, 0.16},
                                                   {1.46, 0.22}, {1.30, 0.30}, {1.06, 0.34}};
    const double shaft = columnHeight - 0.34 - 0.36;
    for (int i = 0; i <= 8; ++i) profile.emplace_back(1.0 - 0.16 * i * i / 64.0, 0.34 + shaft * (i + 0.15) / 8.3);
    const double top = columnHeight;
    for (const auto& [width, below] :
         {std::pair(0.95, 0.33), {0.98, 0.28}, {1.20, 0.20}, {1.48, 0.13}, {1.48, 0.0}, {0.0, 0.0}})
        profile.emplace_back(width, top - below);
    for (auto& [width, height] : profile) width *= radius;
    return turned(profile, sides);
}

struct Ring {
    double radius = 1.0;
    int columns = 1;
    double shaft = 0.2;  ///< radius of a column

    double angleOf(double column) const { return 2.0 * pi * column / columns; }
    /// x across, y up, z outwards.
    RigidPose at(double column, double height) const {
        const double angle = angleOf(column);
        const glm::dvec3 out(std::cos(angle), 0.0, -std::sin(angle)), up(0.0, 1.0, 0.0);
        return {radius * out + height * up, {glm::cross(up, out), up, out}};
    }
};

void addRing(SceneParts& parts, const Ring& ring, bool hasBeams) {
    const auto shaft = std::make_shared<const Shape>(column(ring.shaft, 32));
    const double chord = 2.0 * ring.radius * std::sin(pi / ring.columns);
    const auto beam = std::make_shared<const Shape>(box({chord + 0.9 * ring.shaft, 0.36, 2.4 * ring.shaft}, {6, 2, 2}));
    for (int i = 0; i < ring.columns; ++i) {
        MeshInstance standing;
        standing.shape = shaft;
        standing.material = 1;
        standing.pose = ring.at(i, 0.0);
        parts.instances.push_back(std::move(standing));
        if (!hasBeams) continue;
        MeshInstance lying;
        lying.shape = beam;
        lying.material = 2;
        lying.pose = ring.at(i + 0.5, 0.0);
        // Neighbours overlap: each second one is a little higher, so that no two faces lie in one plane.
        lying.pose.position *= std::cos(pi / ring.columns);
        lying.pose.position.y = columnHeight + 0.18 + (i % 2 == 0 ? 0.0 : 0.008);
        parts.instances.push_back(std::move(lying));
    }
}

void addCloths(SceneParts& parts, const Ring& ring, double size, int wavesInAll) {
    for (int i = 0; i < ring.columns; i += 2) {
        Cloth cloth;
        cloth.width = 1.45;
        cloth.height = 2.3;
        cloth.size = size;
        cloth.period = parts.duration;
        cloth.waves = wavesInAll + i % 3;
        cloth.phase = 0.37 * i;
        cloth.place = ring.at(i + 0.5, columnHeight - 0.04);
        cloth.place.position *= glm::dvec3(std::cos(pi / ring.columns), 1.0, std::cos(pi / ring.columns));
        MeshInstance hanging;
        hanging.shape = hangingCloth(cloth);
        hanging.material = 3 + static_cast<std::uint32_t>(i / 2 % 3);
        if (size > 0.0) hanging.flesh = wavingCloth(cloth);
        parts.instances.push_back(std::move(hanging));
    }
}

}  // namespace

const RecipeDescription& Runner::description() const {
    static const RecipeDescription description{
        "runner", "a skinned runner in a round colonnade, between columns and cloths that wave"};
    return description;
}

void Runner::visitSettings(SettingsVisitor& visitor) {
    visitor.number("cell", cell_, 7.0, 4.0, 20.0, "mm",
                   "About how large the body's triangles are; their number falls with its square.");
    visitor.whole("pace", pace_, 20, 8, 48, "frames", "In how many frames the runner makes two steps.");
    visitor.number("wind", wind_, 0.2, 0.0, 0.4, "m", "How far the cloths wave.");
}

std::unique_ptr<Scene> Runner::make() {
    SceneParts parts;
    parts.name = description().name;
    parts.parameters = parametersOf(*this);
    const auto [radius, strides] = roundTrack(4.6);
    const Track track{radius};
    const double pace = pace_ / framesPerSecond;
    parts.duration = strides * pace;
    parts.defaults = {std::floor(shownStride * pace_), framesPerSecond, 1.0};
    parts.materials = {matt("floor", {0.30f, 0.26f, 0.20f}, 0.9f),
                       matt("column", {0.46f, 0.42f, 0.35f}, 0.85f),
                       matt("beam", {0.42f, 0.38f, 0.31f}, 0.85f),
                       matt("red cloth", {0.58f, 0.07f, 0.06f}, 0.9f),
                       matt("blue cloth", {0.07f, 0.16f, 0.42f}, 0.9f),
                       matt("ochre cloth", {0.70f, 0.44f, 0.08f}, 0.9f),
                       matt("runner", glm::vec3(1.0f), 0.6f)};
    for (std::size_t cloth = 3; cloth < 6; ++cloth) parts.materials[cloth].doubleSided = true;
    parts.instances.push_back(ground(groundSide, 0));
    const Ring outer{radius + 1.5, outerColumns, 0.22}, inner{radius - 1.7, innerColumns, 0.20};
    addRing(parts, outer, true);
    addRing(parts, inner, false);
    addCloths(parts, outer, static_cast<double>(wind_), static_cast<int>(std::lround(parts.duration / 0.8)));
    parts.instances.push_back(skinnedRunner(0.001 * static_cast<double>(cell_), pace, track, 6));

    const double along = shownStride * strideLength;
    const glm::dmat3 heading = track.heading(along);
    const auto beside = [&](const glm::dvec3& offset) { return track.at(along, 0.0) + heading * offset; };
    parts.cameras.emplace_back("colonnade", staticCamera(beside({1.45, 1.6, 4.5}), beside({0.05, 0.98, -0.3}), 0.60));
    parts.cameras.emplace_back("above", staticCamera(beside({4.2, 10.0, 5.5}), beside({1.6, 0.0, -0.5}), 0.62));
    parts.light = staticSpot(beside({6.2, 7.6, 1.6}), beside({-0.3, 0.7, -0.6}), 0.50, 0.62);
    parts.bounds.add(glm::dvec3(-0.5 * groundSide, -0.1, -0.5 * groundSide));
    parts.bounds.add(glm::dvec3(0.5 * groundSide, columnHeight + 0.6, 0.5 * groundSide));
    return std::make_unique<MeshScene>(std::move(parts));
}

}  // namespace timeshade
