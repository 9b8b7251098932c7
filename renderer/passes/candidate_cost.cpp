#include "passes/candidate_cost.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "plan/view_triangle.h"

namespace timeshade {

namespace {

/// Relative prices, fitted to measured frames (about nanoseconds on two cores of a software renderer): an entry is
/// counted and written, an item (triangle and bucket) is set up twice, a cell is cleared and scanned, a candidate's
/// bounds are looked at, a candidate whose bounds hold the receiver is tested. Fitted over cubes, octopus and chess
/// with sides of 128 to 512 and 1 to 8 buckets.
constexpr double entryPrice = 40.0, itemPrice = 14.0, cellPrice = 21.0, boundsPrice = 0.8, testPrice = 5.6;
/// How much more often than on average over the map receivers lie where casters are: what moves is what a camera is
/// turned to.
constexpr double staticCrowding = 1.8, dynamicCrowding = 4.0;
constexpr int maxBuckets = 32;
constexpr double boundsSteps = 16.0;  // per cell, of a candidate's bounds

struct Extent {
    glm::dvec2 size, way;  // of the bounds at one instant, and how far they move; map widths, clipped to the map
};

Extent extentOf(const ViewPlan& light, const ViewTriangle& triangle) {
    ViewTriangle open = triangle, close = triangle;
    std::copy(std::begin(open.open), std::end(open.open), std::begin(open.close));
    std::copy(std::begin(close.close), std::end(close.close), std::begin(close.open));
    const auto clipped = [](const shared::SweptBounds& bounds) {
        return glm::dvec2(glm::clamp(bounds.high, 0.0f, 1.0f)) - glm::dvec2(glm::clamp(bounds.low, 0.0f, 1.0f));
    };
    Extent extent;
    extent.size = 0.5 * (clipped(boundsOf(light, open)) + clipped(boundsOf(light, close)));
    extent.way = glm::max(clipped(boundsOf(light, triangle)) - extent.size, glm::dvec2(0.0));
    return extent;
}

std::vector<Extent> pick(const FramePlan& plan, const std::vector<std::uint32_t>& ids, double& each) {
    const std::size_t step = std::max<std::size_t>(1, (ids.size() + 2047) / 2048);
    std::vector<Extent> extents;
    for (std::size_t i = 0; i < ids.size(); i += step)
        extents.push_back(extentOf(plan.light, viewTriangle(plan.light.block, plan.texels->positions, ids[i])));
    each = extents.empty() ? 0.0 : static_cast<double>(ids.size()) / static_cast<double>(extents.size());
    return extents;
}

double entriesOf(const std::vector<Extent>& extents, double side, double buckets) {
    double sum = 0.0;
    for (const Extent& extent : extents) {
        const glm::dvec2 bounds = (extent.size + extent.way / buckets) * side;
        sum += 0.5 * (bounds.x + 1.0) * (bounds.y + 1.0) + 0.5;  // half of a triangle's bounds is empty
    }
    return sum;
}

/// Triangles whose bounds, in steps of a sixteenth of a cell, hold a point of the map: their areas' sum.
double boundsArea(const std::vector<Extent>& extents, double side, double buckets) {
    double sum = 0.0;
    for (const Extent& extent : extents) {
        const glm::dvec2 bounds = extent.size + extent.way / buckets + 1.0 / (boundsSteps * side);
        sum += bounds.x * bounds.y;
    }
    return sum;
}

}  // namespace

CandidateGridSize chooseCandidateGrid(const FramePlan& plan, const std::vector<std::uint32_t>& casters, bool move,
                                      int side, int buckets) {
    double each = 0.0;
    const std::vector<Extent> extents = pick(plan, casters, each);
    const double samples = static_cast<double>(plan.block.imageSize.x) * plan.block.imageSize.y * plan.block.strata;
    const double crowding = move ? dynamicCrowding : staticCrowding;
    const int fewest = buckets > 0 && move ? buckets : 1, most = !move || casters.empty() ? 1
                                                                 : buckets > 0            ? buckets
                                                                                          : maxBuckets;

    CandidateGridSize best;
    double lowest = 1e300;
    const int highestSide = std::min(plan.request.mapSize.longerSide(), 1024);
    for (int s = side > 0 ? side : 16; s <= (side > 0 ? side : highestSide); s *= 2) {
        for (int b = fewest; b <= std::max(fewest, most); b *= 2) {
            const double cells = static_cast<double>(s) * s;
            const double entries = b * each * entriesOf(extents, s, b);
            const double looked = entries / (cells * b), tested = each * boundsArea(extents, s, b);
            const double cost = entryPrice * entries + itemPrice * b * static_cast<double>(casters.size()) +
                                crowding * samples * (boundsPrice * looked + testPrice * tested) +
                                cellPrice * cells * b;
            if (cost >= lowest) continue;
            lowest = cost;
            best = {s, b, entries, crowding * tested};
        }
    }
    return best;
}

}  // namespace timeshade
