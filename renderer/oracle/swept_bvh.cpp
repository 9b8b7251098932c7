#include "oracle/swept_bvh.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "shared/frame_blocks.shared.h"

namespace timeshade::oracle {

std::uint32_t MovingTriangles::count() const {
    return static_cast<std::uint32_t>(texels_.size() / TRIANGLE_POSITION_TEXELS);
}

bool MovingTriangles::doubleSided(std::uint32_t id) const {
    return texels_[std::size_t{id} * TRIANGLE_POSITION_TEXELS + 4].z != 0.0f;
}

glm::dvec3 MovingTriangles::end(std::uint32_t id, int vertex, bool close) const {
    const int first = 3 * vertex + (close ? 9 : 0);
    glm::dvec3 position;
    for (int c = 0; c < 3; ++c) {
        const int i = first + c;
        position[c] = static_cast<double>(
            texels_[std::size_t{id} * TRIANGLE_POSITION_TEXELS + static_cast<std::size_t>(i / 4)][i % 4]);
    }
    return position;
}

void MovingTriangles::at(std::uint32_t id, double u, glm::dvec3 (&vertices)[3]) const {
    for (int v = 0; v < 3; ++v) vertices[v] = end(id, v, false) * (1.0 - u) + end(id, v, true) * u;
}

void SweptBox::add(const SweptBox& other) {
    for (int e = 0; e < 2; ++e) {
        low[e] = glm::min(low[e], other.low[e]);
        high[e] = glm::max(high[e], other.high[e]);
    }
}

double SweptBox::area() const {
    double sum = 0.0;
    for (int e = 0; e < 2; ++e) {
        const glm::dvec3 d = high[e] - low[e];
        sum += d.x * d.y + d.y * d.z + d.z * d.x;
    }
    return sum;
}

/// Top-down, by the surface area heuristic over bins of the centroids half-way through the shutter.
struct SweptBvh::Builder {
    static constexpr std::uint32_t leafSize = 4;
    static constexpr int bins = 16;
    static constexpr int depthForMedians = maximumDepth - 34;  // halving takes 32 levels at most from there

    SweptBvh& bvh;
    std::vector<SweptBox> boxes;
    std::vector<glm::dvec3> centroids;

    struct Split {
        int axis = -1;
        double position = 0.0;
        double cost = HUGE_VAL;
    };

    void build(std::uint32_t index, std::uint32_t begin, std::uint32_t end, int depth) {
        SweptBox box;
        for (std::uint32_t i = begin; i < end; ++i) box.add(boxes[bvh.order_[i]]);
        bvh.nodes_[index].box = box;
        const std::uint32_t middle = end - begin <= leafSize ? begin : divide(begin, end, depth);
        if (middle == begin) {
            bvh.nodes_[index].first = begin;
            bvh.nodes_[index].count = end - begin;
            return;
        }
        const auto children = static_cast<std::uint32_t>(bvh.nodes_.size());
        bvh.nodes_[index].first = children;
        bvh.nodes_.resize(bvh.nodes_.size() + 2);
        build(children, begin, middle, depth + 1);
        build(children + 1, middle, end, depth + 1);
    }

    std::uint32_t divide(std::uint32_t begin, std::uint32_t end, int depth) {
        const auto from = bvh.order_.begin() + begin, to = bvh.order_.begin() + end;
        glm::dvec3 low(1e300), high(-1e300);
        for (auto i = from; i != to; ++i) {
            low = glm::min(low, centroids[*i]);
            high = glm::max(high, centroids[*i]);
        }
        Split best;
        if (depth < depthForMedians)
            for (int axis = 0; axis < 3; ++axis)
                if (const Split split = bestSplit(begin, end, axis, low[axis], high[axis]); split.cost < best.cost)
                    best = split;
        if (best.axis >= 0) {
            const auto middle =
                std::partition(from, to, [&](std::uint32_t id) { return centroids[id][best.axis] < best.position; });
            if (middle != from && middle != to) return static_cast<std::uint32_t>(middle - bvh.order_.begin());
        }
        const glm::dvec3 extent = high - low;
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
        const std::uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(from, bvh.order_.begin() + middle, to, [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(centroids[a][axis], a) < std::pair(centroids[b][axis], b);
        });
        return middle;
    }

    Split bestSplit(std::uint32_t begin, std::uint32_t end, int axis, double low, double high) const {
        Split best;
        if (!(high > low)) return best;
        std::array<SweptBox, bins> binBoxes;
        std::array<double, bins> binCounts{};
        const double scale = bins / (high - low);
        for (std::uint32_t i = begin; i < end; ++i) {
            const std::uint32_t id = bvh.order_[i];
            const auto bin = static_cast<std::size_t>(std::min((centroids[id][axis] - low) * scale, bins - 1.0));
            binBoxes[bin].add(boxes[id]);
            binCounts[bin] += 1.0;
        }
        std::array<double, bins> costOfRight{};
        SweptBox right;
        double count = 0.0;
        for (std::size_t b = bins - 1; b > 0; --b) {
            right.add(binBoxes[b]);
            count += binCounts[b];
            costOfRight[b] = count > 0.0 ? count * right.area() : HUGE_VAL;
        }
        SweptBox left;
        count = 0.0;
        for (std::size_t b = 0; b + 1 < bins; ++b) {
            left.add(binBoxes[b]);
            count += binCounts[b];
            const double cost = count > 0.0 ? count * left.area() + costOfRight[b + 1] : HUGE_VAL;
            if (cost < best.cost) best = {axis, low + static_cast<double>(b + 1) / scale, cost};
        }
        return best;
    }
};

SweptBvh::SweptBvh(const MovingTriangles& triangles) {
    const std::uint32_t count = triangles.count();
    if (count == 0) return;
    Builder builder{*this, std::vector<SweptBox>(count), std::vector<glm::dvec3>(count)};
    for (std::uint32_t id = 0; id < count; ++id) {
        SweptBox& box = builder.boxes[id];
        for (int e = 0; e < 2; ++e)
            for (int v = 0; v < 3; ++v) {
                const glm::dvec3 position = triangles.end(id, v, e == 1);
                box.low[e] = glm::min(box.low[e], position);
                box.high[e] = glm::max(box.high[e], position);
                for (int c = 0; c < 3; ++c) largestCoordinate_ = std::max(largestCoordinate_, std::abs(position[c]));
            }
        builder.centroids[id] = 0.25 * (box.low[0] + box.high[0] + box.low[1] + box.high[1]);
    }
    order_.resize(count);
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.resize(1);
    builder.build(0, 0, count, 0);
}

}  // namespace timeshade::oracle
