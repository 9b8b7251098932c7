#include "scenes/blobs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "core/check.h"
#include "core/parallel.h"

namespace timeshade {

namespace {

constexpr int side = 8;  ///< cells along a block
constexpr int corners = side + 1;
constexpr double slope = 1.3;             ///< of a distance, at most
constexpr double farthestMelting = 0.20;  ///< twice the widest: beyond it no sign depends on a blob

double melted(double first, double second, double melting) {
    const double share = std::max(melting - std::abs(first - second), 0.0) / melting;
    return std::min(first, second) - 0.25 * share * share * melting;
}

struct Value {
    double distance = std::numeric_limits<double>::infinity();
    std::uint32_t layer = 0;
};

using Some = std::vector<const Blob*>;

/// Outside of all of these, and the nearest layer.
Value valueAt(const Some& blobs, const glm::dvec3& place) {
    Value value;
    double layered = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < blobs.size(); ++i) {
        const Blob& blob = *blobs[i];
        if (i > 0 && blobs[i - 1]->layer != blob.layer) layered = std::numeric_limits<double>::infinity();
        const double distance = distanceTo(blob, place);
        layered = std::isinf(layered) ? distance : melted(layered, distance, blob.melting);
        if (layered < value.distance) value = {layered, blob.layer};
    }
    return value;
}

glm::dvec3 slopeAt(const Some& blobs, const glm::dvec3& place, double step) {
    glm::dvec3 slopes;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 low = place, high = place;
        low[axis] -= step;
        high[axis] += step;
        slopes[axis] = (valueAt(blobs, high).distance - valueAt(blobs, low).distance) / (2.0 * step);
    }
    return slopes;
}

/// Eight cells along each side; where the surface may pass through.
struct Block {
    glm::ivec3 first{0};  ///< its lowest corner, in cells
    Some blobs;           ///< that matter here
    std::vector<double> values;
    struct Vertex {
        glm::ivec3 cell;
        glm::dvec3 position;
        glm::vec3 normal;
        std::uint32_t layer;
    };
    std::vector<Vertex> vertices;

    double at(const glm::ivec3& corner) const {
        return values[static_cast<std::size_t>((corner.z * corners + corner.y) * corners + corner.x)];
    }
};

constexpr std::array<glm::ivec3, 3> axes{glm::ivec3(1, 0, 0), glm::ivec3(0, 1, 0), glm::ivec3(0, 0, 1)};

void evaluate(Block& block, double cell) {
    block.values.reserve(corners * corners * corners);
    for (int z = 0; z < corners; ++z)
        for (int y = 0; y < corners; ++y)
            for (int x = 0; x < corners; ++x)
                block.values.push_back(
                    valueAt(block.blobs, cell * glm::dvec3(block.first + glm::ivec3(x, y, z))).distance);
}

/// The mean of where the surface crosses the cell's edges; false where it crosses none.
bool crossing(const Block& block, const glm::ivec3& cell, glm::dvec3& mean) {
    int count = 0;
    mean = glm::dvec3(0.0);
    for (int axis = 0; axis < 3; ++axis)
        for (int edge = 0; edge < 4; ++edge) {
            glm::ivec3 from = cell;
            from[(axis + 1) % 3] += edge & 1;
            from[(axis + 2) % 3] += edge >> 1;
            const double low = block.at(from), high = block.at(from + axes[static_cast<std::size_t>(axis)]);
            if ((low < 0.0) == (high < 0.0)) continue;
            glm::dvec3 place(from);
            place[axis] += low / (low - high);
            mean += place;
            ++count;
        }
    if (count > 0) mean /= count;
    return count > 0;
}

void addVertices(Block& block, double cell) {
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                glm::dvec3 mean;
                if (!crossing(block, {x, y, z}, mean)) continue;
                glm::dvec3 place = cell * (glm::dvec3(block.first) + mean);
                glm::dvec3 slopes(0.0, 1.0, 0.0);
                for (int step = 0; step < 2; ++step) {
                    slopes = slopeAt(block.blobs, place, 0.25 * cell);
                    const double square = glm::dot(slopes, slopes);
                    if (square < 1e-6) break;
                    glm::dvec3 way = valueAt(block.blobs, place).distance / square * slopes;
                    if (glm::length(way) > 0.3 * cell) way *= 0.3 * cell / glm::length(way);
                    place -= way;
                }
                slopes = slopeAt(block.blobs, place, 0.5 * cell);
                const double length = glm::length(slopes);
                block.vertices.push_back({block.first + glm::ivec3(x, y, z), place,
                                          length > 1e-6 ? glm::vec3(slopes / length) : glm::vec3(0.0f, 1.0f, 0.0f),
                                          valueAt(block.blobs, place).layer});
            }
}

std::vector<Block> blocksOf(const std::vector<Blob>& blobs, double cell) {
    glm::dvec3 low(1e9), high(-1e9);
    for (const Blob& blob : blobs)
        for (const glm::dvec3& end : {blob.a, blob.b}) {
            low = glm::min(low, end - std::max(blob.radiusA, blob.radiusB));
            high = glm::max(high, end + std::max(blob.radiusA, blob.radiusB));
        }
    const double width = side * cell, reach = slope * 0.5 * std::sqrt(3.0) * width;
    const glm::ivec3 first = glm::ivec3(glm::floor(low / width)) - 1, last = glm::ivec3(glm::floor(high / width)) + 1;
    Some all;
    for (const Blob& blob : blobs) all.push_back(&blob);
    std::vector<Block> blocks;
    for (int z = first.z; z <= last.z; ++z)
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) {
                const glm::dvec3 centre = width * (glm::dvec3(x, y, z) + 0.5);
                if (std::abs(valueAt(all, centre).distance) > reach) continue;
                Block block;
                block.first = side * glm::ivec3(x, y, z);
                for (const Blob* blob : all)
                    if (distanceTo(*blob, centre) < reach + farthestMelting) block.blobs.push_back(blob);
                blocks.push_back(std::move(block));
            }
    return blocks;
}

std::uint64_t keyOf(const glm::ivec3& cell) {
    const auto bits = [](int value) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(value + 65536)); };
    return bits(cell.x) | bits(cell.y) << 20 | bits(cell.z) << 40;
}

using Numbers = std::unordered_map<std::uint64_t, std::uint32_t>;

/// Two triangles between the four cells around each edge that the surface crosses, along the shorter diagonal.
void addFaces(Shape& shape, const Block& block, const Numbers& numbers) {
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                for (int axis = 0; axis < 3; ++axis) {
                    const glm::ivec3 corner(x, y, z);
                    const bool inside = block.at(corner) < 0.0;
                    if (inside == (block.at(corner + axes[static_cast<std::size_t>(axis)]) < 0.0)) continue;
                    const glm::ivec3 across = axes[static_cast<std::size_t>((axis + 1) % 3)],
                                     up = axes[static_cast<std::size_t>((axis + 2) % 3)], at = block.first + corner;
                    std::array<std::uint32_t, 4> quad{numbers.at(keyOf(at - across - up)), numbers.at(keyOf(at - up)),
                                                      numbers.at(keyOf(at)), numbers.at(keyOf(at - across))};
                    if (!inside) std::swap(quad[1], quad[3]);
                    const auto apart = [&](int i, int j) {
                        return glm::length(shape.positions[quad[static_cast<std::size_t>(i)]] -
                                           shape.positions[quad[static_cast<std::size_t>(j)]]);
                    };
                    const bool first = apart(0, 2) <= apart(1, 3);
                    shape.triangles.emplace_back(quad[0], quad[1], first ? quad[2] : quad[3]);
                    shape.triangles.emplace_back(quad[first ? 0 : 1], quad[2], quad[3]);
                }
}

}  // namespace

double distanceTo(const Blob& blob, const glm::dvec3& place) {
    const glm::dvec3 squeeze(1.0, 1.0, 1.0 / blob.depth);
    const glm::dvec3 from = (place - blob.a) * squeeze, along = (blob.b - blob.a) * squeeze;
    const double share = std::clamp(glm::dot(from, along) / glm::dot(along, along), 0.0, 1.0);
    const double round = blob.depth * (glm::length(from - share * along) - glm::mix(blob.radiusA, blob.radiusB, share));
    return blob.cutTo == glm::dvec3(0.0) ? round : std::max(round, glm::dot(place, blob.cutTo) - blob.cutAt);
}

LayeredShape surfaceOf(const std::vector<Blob>& blobs, double cell) {
    CHECK(!blobs.empty());
    CHECK(cell > 0.0);
    for (const Blob& blob : blobs) CHECK_LE(blob.melting, 0.5 * farthestMelting);
    std::vector<Blob> sorted = blobs;  // by layer, and within one in their own order
    std::stable_sort(sorted.begin(), sorted.end(), [](const Blob& a, const Blob& b) { return a.layer < b.layer; });
    std::vector<Block> blocks = blocksOf(sorted, cell);
    forEachOf(blocks.size(), 16, [&](std::size_t i) {
        evaluate(blocks[i], cell);
        addVertices(blocks[i], cell);
    });
    LayeredShape result;
    Numbers numbers;
    for (const Block& block : blocks)
        for (const Block::Vertex& vertex : block.vertices) {
            numbers[keyOf(vertex.cell)] = static_cast<std::uint32_t>(result.shape.positions.size());
            result.shape.positions.push_back(vertex.position);
            result.shape.normals.push_back(vertex.normal);
            result.layers.push_back(vertex.layer);
        }
    for (const Block& block : blocks) addFaces(result.shape, block, numbers);
    return result;
}

}  // namespace timeshade
