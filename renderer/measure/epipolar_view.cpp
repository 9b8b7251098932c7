#include "measure/epipolar_view.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace timeshade {

namespace {

/// Cells of the plane of x and u, a pixel of the picture each.
constexpr std::uint32_t columnCount = 440, rowCount = 400;
constexpr int pathSteps = 64;  // a path is a curve where a spot's receiver changes its distance

glm::dvec2 sidesOf(const FramePlan& plan) { return plan.request.mapSize.sides(); }

bool insideMap(const glm::dvec2& p) { return p.x >= 0.0 && p.x <= 1.0 && p.y >= 0.0 && p.y <= 1.0; }

/// How far along `direction` from an inner place the map's border is.
double reachOf(const glm::dvec2& place, const glm::dvec2& direction) {
    double reach = 2.0;
    for (int axis = 0; axis < 2; ++axis)
        if (direction[axis] != 0.0)
            reach = std::min(reach, ((direction[axis] > 0.0 ? 1.0 : 0.0) - place[axis]) / direction[axis]);
    return reach;
}

/// Of a point that is at `position` at time `at`, from the shutter's opening to its close, in the map.
glm::dvec2 motionInMap(const Oracle& oracle, const FramePlan& plan, std::uint32_t triangle, const glm::dvec3& position,
                       double at) {
    const auto placeAt = [&](double u) {
        return mapPlaceOf(plan, oracle.followed(triangle, position, at, u), u).position;
    };
    return placeAt(1.0) - placeAt(0.0);
}

/// So far on both sides of the place, or to the border.
MapLine lineAround(const glm::dvec2& place, const glm::dvec2& direction, double half) {
    return {place - direction * std::min(half, reachOf(place, -direction)),
            place + direction * std::min(half, reachOf(place, direction))};
}

auto orderOf(const StoredMark& m) {
    return std::tuple(m.xFrom, m.uFrom, m.uTo, m.depthFrom, m.depthTo, m.triangle, m.uFromSlope, m.uToSlope);
}

EpipolarPlace placeOf(const Oracle& oracle, const FramePlan& plan, const MapLine& line, std::uint32_t triangle,
                      const OracleAnswer& answer, double u) {
    const glm::dvec3 p = oracle.followed(triangle, answer.position, static_cast<double>(answer.time), u);
    const MapPlace place = mapPlaceOf(plan, p, u);
    return {line.alongOf(place.position), u, place.depth};
}

/// Of a value's mean over time.
void setFootprint(const FramePlan& plan, const Footprint& footprint, std::uint32_t stratum, EpipolarSample& sample) {
    sample.uFrom = sample.uTo = sample.place.u;
    if (footprint.time == Footprint::Time::Shutter) {
        sample.uFrom = 0.0;
        sample.uTo = 1.0;
    } else if (footprint.time == Footprint::Time::Stratum) {
        const auto base = static_cast<double>(plan.block.timeBase), length = static_cast<double>(plan.block.timeScale);
        sample.uFrom = base + stratum * length;
        sample.uTo = base + (stratum + 1) * length;
    }
}

/// The samples of a pixel of the last render.
void addSamples(const FrameRenderer& renderer, const Oracle& oracle, const FramePlan& render,
                const Footprint& footprint, glm::uvec2 pixel, EpipolarView& view) {
    const std::vector<std::uint32_t> triangles = renderer.readSampleIds();
    const std::vector<float> lit = renderer.readVisibility();
    const glm::uvec2 size = render.block.imageSize;
    for (std::uint32_t stratum = 0; stratum < render.block.strata; ++stratum) {
        const std::size_t i = (std::size_t{stratum} * size.y + pixel.y) * size.x + pixel.x;
        if (triangles[i] == NO_TRIANGLE) continue;
        const OracleAnswer answer = oracle.resolve(render, {pixel.x, pixel.y, stratum}, triangles[i]);
        EpipolarSample sample;
        const auto u = static_cast<double>(answer.time);
        sample.place = placeOf(oracle, render, view.line, triangles[i], answer, u);
        for (int step = 0; step <= pathSteps; ++step)
            sample.path.push_back(
                placeOf(oracle, render, view.line, triangles[i], answer, static_cast<double>(step) / pathSteps));
        sample.texelsOff = view.line.texelsFrom(mapPlaceOf(render, answer.position, u).position, sidesOf(render));
        sample.tested = answer.tested;
        sample.lit = static_cast<double>(lit[i]);
        sample.truth = answer.lit;
        setFootprint(render, footprint, stratum, sample);
        view.samples.push_back(std::move(sample));
    }
}

}  // namespace

std::optional<MapLine> lineThroughPixel(const Oracle& oracle, const FramePlan& plan, glm::uvec2 pixel) {
    for (std::uint32_t stratum = 0; stratum < plan.block.strata; ++stratum) {
        const SampleIndex index{pixel.x, pixel.y, stratum};
        const std::uint32_t triangle = oracle.resolvePrimary(plan, index).triangle;
        if (triangle == NO_TRIANGLE) continue;
        const OracleAnswer answer = oracle.resolve(plan, index, triangle);
        const auto at = static_cast<double>(answer.time);
        const MapPlace place = mapPlaceOf(plan, answer.position, at);
        if (!(place.depth > 0.0) || !insideMap(place.position)) continue;
        glm::dvec2 motion(0.0);
        const SeenByLight seen = oracle.seenByLight(plan, place.position, 0.5);
        if (seen.triangle != NO_TRIANGLE) {
            const LightRay ray = lightRayThrough(plan, place.position, 0.5);
            motion = motionInMap(oracle, plan, seen.triangle, ray.from + seen.depth * ray.direction, 0.5);
        }
        const glm::dvec2 sides = sidesOf(plan);
        const auto moves = [&] { return glm::length(motion * sides) >= 1.0; };
        if (!moves()) motion = motionInMap(oracle, plan, triangle, answer.position, at);
        if (!moves()) return lineAround(place.position, {1.0, 0.0}, 1.0);
        return lineAround(place.position, glm::normalize(motion), 2.0 * glm::length(motion) + 16.0 / sides.x);
    }
    return std::nullopt;
}

EpipolarView epipolarView(FrameRenderer& renderer, const Oracle& oracle, const FramePlan& plan, Technique& technique,
                          const MapLine& line, std::optional<glm::uvec2> pixel) {
    EpipolarView view;
    view.line = line;
    view.mapSize = {plan.request.mapSize.width, plan.request.mapSize.height};
    view.columns = columnCount;
    view.rows = rowCount;
    view.truth = oracle.seenAlong(plan, line, columnCount, rowCount);
    view.instances = plan.mesh->topology->triangleInstances;
    renderer.begin(plan, technique, View::Visibility);
    for (bool complete = false; !complete;) {
        const int m = renderer.rendersDone();
        complete = renderer.step();
        StoredAlongLine stored = renderer.storedAlong(line);
        view.stored.note = stored.note;
        view.stored.marks.insert(view.stored.marks.end(), stored.marks.begin(), stored.marks.end());
        if (!pixel) continue;
        const int renders = renderer.renders();
        addSamples(renderer, oracle, renders > 1 ? planAtInstant(plan, m, renders) : plan, technique.footprint(),
                   *pixel, view);
    }
    // Lists on a device are in no order of their own.
    std::sort(view.stored.marks.begin(), view.stored.marks.end(),
              [](const StoredMark& a, const StoredMark& b) { return orderOf(a) < orderOf(b); });
    return view;
}

}  // namespace timeshade
