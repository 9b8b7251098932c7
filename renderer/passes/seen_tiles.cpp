#include "passes/seen_tiles.h"

#include <algorithm>
#include <cmath>

#include "plan/view_triangle.h"

namespace timeshade {

namespace {

constexpr float slack = 1.0f / 64.0f;  // pixels
constexpr int mostBuckets = 16;
constexpr int mostSide = 8;  // of a tile, pixels
constexpr double halfTile = 0.5 * mostSide;
constexpr std::size_t longList = 300;  // tiles are halved while there are longer ones

/// A triangle's bounds in pixels.
struct Extent {
    glm::vec2 low, high;
    bool isEmpty;
};

/// Of a bucket of time, from u0 to u1.
Extent extentOf(const ViewPlan& camera, const ViewTriangle& triangle, float u0, float u1) {
    const shared::SweptBounds bounds = boundsOf(camera, triangle, u0, u1);
    const glm::vec2 size = camera.block.size;
    Extent extent{};
    extent.low = glm::clamp(bounds.low * size - slack, glm::vec2(-1.0f), size + 1.0f);
    extent.high = glm::clamp(bounds.high * size + slack, glm::vec2(-1.0f), size + 1.0f);
    extent.isEmpty = bounds.low.x > bounds.high.x;
    return extent;
}

std::uint32_t boundsInTile(const Extent& extent, glm::ivec2 tile, float side) {
    const glm::vec2 corner = glm::vec2(tile) * side;
    const glm::vec2 low = glm::clamp(glm::floor((extent.low - corner) * (255.0f / side)), 0.0f, 255.0f);
    const glm::vec2 high = glm::clamp(glm::ceil((extent.high - corner) * (255.0f / side)), 0.0f, 255.0f);
    return static_cast<std::uint32_t>(low.x) | static_cast<std::uint32_t>(low.y) << 8 |
           static_cast<std::uint32_t>(high.x) << 16 | static_cast<std::uint32_t>(high.y) << 24;
}

std::vector<std::uint32_t> movingTriangles(const TriangleLists& lists) {
    std::vector<std::uint32_t> ids(lists.count());
    std::merge(lists.small.begin(), lists.small.end(), lists.large.begin(), lists.large.end(), ids.begin());
    return ids;
}

void appendTriangle(std::vector<glm::vec4>& texels, const ViewTriangle& t) {
    const glm::vec3 &a0 = t.open[0], &a1 = t.open[1], &a2 = t.open[2], &b0 = t.close[0], &b1 = t.close[1],
                    &b2 = t.close[2];
    texels.insert(texels.end(), {{a0.x, a0.y, a0.z, a1.x},
                                 {a1.y, a1.z, a2.x, a2.y},
                                 {a2.z, b0.x, b0.y, b0.z},
                                 {b1.x, b1.y, b1.z, b2.x},
                                 {b2.y, b2.z, t.doubleSided ? 1.0f : 0.0f, 0.0f}});
}

/// Every list that an extent belongs to: those of its bucket, of the tiles that it reaches.
template <typename Visit>
void forEachList(const SeenTiles& tiles, const Extent& extent, std::size_t bucket, Visit visit) {
    if (extent.isEmpty) return;
    const auto side = static_cast<float>(tiles.side);
    const glm::ivec2 first = glm::max(glm::ivec2(glm::floor(extent.low / side)), glm::ivec2(0));
    const glm::ivec2 last =
        glm::min(glm::ivec2(glm::floor(extent.high / side)), glm::ivec2(tiles.columns, tiles.rows) - 1);
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x)
            visit(static_cast<std::size_t>(y * tiles.columns + x) * static_cast<std::size_t>(tiles.buckets) + bucket,
                  glm::ivec2(x, y));
}

/// Fills in offsets; returns the longest list. Extents: of each triangle, one a bucket.
std::size_t countLists(SeenTiles& tiles, const std::vector<Extent>& extents, glm::ivec2 size) {
    tiles.columns = (size.x + tiles.side - 1) / tiles.side;
    tiles.rows = (size.y + tiles.side - 1) / tiles.side;
    const std::size_t buckets = static_cast<std::size_t>(tiles.buckets);
    tiles.offsets.assign(static_cast<std::size_t>(tiles.columns * tiles.rows) * buckets + 1, 0);
    for (std::size_t i = 0; i < extents.size(); ++i)
        forEachList(tiles, extents[i], i % buckets, [&](std::size_t list, glm::ivec2) { ++tiles.offsets[list + 1]; });
    std::size_t longest = 0;
    for (std::size_t i = 1; i < tiles.offsets.size(); ++i) {
        longest = std::max<std::size_t>(longest, tiles.offsets[i]);
        tiles.offsets[i] += tiles.offsets[i - 1];
    }
    return longest;
}

/// So many that in the mean a triangle moves on by half a tile in one: fewer make lists longer, more repeat what hardly
/// moves.
int bucketsFor(const ViewPlan& camera, const std::vector<ViewTriangle>& triangles) {
    double sum = 0.0;
    for (const ViewTriangle& t : triangles) {
        const shared::SweptBounds all = boundsOf(camera, t), first = boundsOf(camera, t, 0.0f, 0.0f);
        const glm::vec2 grown = (all.high - all.low - (first.high - first.low)) * camera.block.size;
        sum += std::clamp(static_cast<double>(std::max(grown.x, grown.y)), 0.0, mostBuckets * halfTile);
    }
    const double mean = triangles.empty() ? 0.0 : sum / static_cast<double>(triangles.size());
    int buckets = 1;
    while (buckets < mostBuckets && buckets * halfTile < mean) buckets *= 2;
    return buckets;
}

}  // namespace

SeenTiles seenTiles(const FramePlan& plan) {
    SeenTiles tiles;
    tiles.ids = movingTriangles(plan.camera.dynamicTriangles);
    std::vector<ViewTriangle> triangles;
    triangles.reserve(tiles.ids.size());
    for (const std::uint32_t id : tiles.ids) {
        triangles.push_back(viewTriangle(plan.camera.block, plan.texels->positions, id));
        appendTriangle(tiles.triangles, triangles.back());
    }
    tiles.buckets = bucketsFor(plan.camera, triangles);
    const std::size_t buckets = static_cast<std::size_t>(tiles.buckets);
    std::vector<Extent> extents;
    extents.reserve(tiles.ids.size() * buckets);
    for (const ViewTriangle& triangle : triangles)
        for (std::size_t b = 0; b < buckets; ++b)
            extents.push_back(extentOf(plan.camera, triangle, static_cast<float>(b) / static_cast<float>(buckets),
                                       static_cast<float>(b + 1) / static_cast<float>(buckets)));
    const glm::ivec2 size(plan.request.width, plan.request.height);
    for (tiles.side = mostSide; countLists(tiles, extents, size) > longList && tiles.side > 1;) tiles.side /= 2;

    tiles.candidates.resize(tiles.offsets.back());
    std::vector<std::uint32_t> next(tiles.offsets.begin(), tiles.offsets.end() - 1);
    for (std::size_t i = 0; i < extents.size(); ++i)
        forEachList(tiles, extents[i], i % buckets, [&](std::size_t list, glm::ivec2 at) {
            tiles.candidates[next[list]++] = {static_cast<std::uint32_t>(i / buckets),
                                              boundsInTile(extents[i], at, static_cast<float>(tiles.side))};
        });
    return tiles;
}

}  // namespace timeshade
