#include "technique/candidate_marks.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "gl/read_back.h"
#include "shared/candidate_bounds.shared.h"

namespace timeshade {

namespace {

/// A depth that what has this step is not nearer than: the inverse of shared::depthStep, rounded down.
double leastDepthOf(const FramePlan& plan, std::uint32_t step) {
    const shared::ViewBlock& view = plan.light.block;
    const float least =
        plan.light.projection == Projection::Orthographic ? view.farDistance / 65536.0f : 128.0f * view.nearDistance;
    const std::uint32_t bits = (step + (std::bit_cast<std::uint32_t>(least) >> 16u)) << 16u;
    return static_cast<double>(std::bit_cast<float>(bits));
}

/// The part of a line inside the bounds of a candidate in a cell; nothing where it passes by them.
std::optional<std::pair<double, double>> partInside(const MapLine& line, const TexelOnLine& cell, int side,
                                                    std::uint32_t bounds) {
    double from = cell.xFrom, to = cell.xTo;
    for (unsigned axis = 0; axis < 2; ++axis) {
        const int a = static_cast<int>(axis);
        const double low = (cell.texel[a] + ((bounds >> (5u * axis)) & 15u) / 16.0) / side;
        const double high = (cell.texel[a] + (16u - ((bounds >> (10u + 5u * axis)) & 15u)) / 16.0) / side;
        const double start = line.from[a], way = line.to[a] - line.from[a];
        if (way == 0.0) {
            if (start < low || start > high) return std::nullopt;
            continue;
        }
        from = std::max(from, std::min((low - start) / way, (high - start) / way));
        to = std::min(to, std::max((low - start) / way, (high - start) / way));
    }
    return from < to ? std::optional(std::pair(from, to)) : std::nullopt;
}

}  // namespace

void addCandidateMarks(const FramePlan& plan, const CandidateGrid& grid, const MapLine& line,
                       std::vector<StoredMark>& marks) {
    const auto side = static_cast<std::size_t>(grid.side());
    for (const TexelOnLine& cell : texelsAlong(line, glm::ivec2(grid.side()))) {
        for (int bucket = 0; bucket < grid.buckets(); ++bucket) {
            const std::size_t list =
                (static_cast<std::size_t>(bucket) * side + static_cast<std::size_t>(cell.texel.y)) * side +
                static_cast<std::size_t>(cell.texel.x);
            const auto span = gl::readElements<GLuint>(grid.offsetsBuffer(), list, 2);
            for (GLuint entry = span[0]; entry < span[1]; ++entry) {
                const std::size_t place = shared::candidatePlace(entry);
                const auto words = gl::readElements<GLuint>(grid.candidatesBuffer(), place, CANDIDATES_TOGETHER + 1);
                const auto part = partInside(line, cell, grid.side(), words.front());
                if (!part) continue;
                const double depth = leastDepthOf(plan, (words.front() >> 20u) & 2047u);
                StoredMark mark{part->first,
                                part->second,
                                static_cast<double>(bucket) / grid.buckets(),
                                static_cast<double>(bucket + 1) / grid.buckets(),
                                depth,
                                depth};
                mark.triangle = words.back() & ~CANDIDATE_MOVES;
                marks.push_back(mark);
            }
        }
    }
}

}  // namespace timeshade
