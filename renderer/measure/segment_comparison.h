#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "oracle/segment_oracle.h"

namespace timeshade {

/// What may be told apart by nothing but the rounding of floats.
struct SegmentTolerance {
    double time = 1e-5;            ///< of u: a difference that lasts no longer does not count
    double pixels = 1.0 / 2000.0;  ///< nor does one that a position so far away does not have: edges that move slowly
};

/// A position that sees something else than it should, for longer than the tolerance.
struct SegmentDisagreement {
    enum class Cause {
        Malformed,  ///< the list is no partition of [0, 1]
        Different,
        EdgeOn,    ///< a triangle that is seen edge-on to within a float's rounding is in one of the lists only
        DepthTie,  ///< two triangles at one depth to within a float's rounding, or one at the near distance
    };
    std::size_t position = 0;
    Cause cause = Cause::Different;
    double u0 = 0.0, u1 = 0.0;  ///< the longest part of the shutter that differs; [0, 1] if malformed
    std::uint32_t got = NO_TRIANGLE, truth = NO_TRIANGLE;  ///< what is seen at its middle
};

struct SegmentComparison {
    std::size_t positions = 0;
    std::size_t beside = 0;      ///< agree, but at some time only with a position within SegmentTolerance::pixels
    double differingTime = 0.0;  ///< over all positions: time with another triangle than the truth's own, any length
    std::vector<SegmentDisagreement> disagreements;  ///< in ascending order of positions, one for each that disagrees

    std::size_t count(SegmentDisagreement::Cause cause) const;
    /// Positions that disagree without being edge-on or tied in depth, in a million.
    double partsPerMillion() const;
};

/// Is the list a partition of [0, 1]? Segments without length and neighbours with one triangle are allowed.
bool isPartition(std::span<const SeenSegment> segments);

/// The parts of [0, 1], longer than `time`, during which the list names another triangle than any of `truths`, in
/// ascending order. `triangle` is that of the list at the longest constant piece of the part. All lists are partitions.
std::vector<SeenSegment> differingParts(std::span<const SeenSegment> got,
                                        std::span<const std::vector<SeenSegment>> truths, double time);

/// What a list of segments in order shows at a time in [0, 1]; of two at their border the later one.
std::uint32_t seenAt(std::span<const SeenSegment> segments, double u);

/// Where `got` and `truth`, a list for each position, disagree. `nearby` gives the lists of positions around one of
/// them, and is called only where the two differ; `doubt` says why two triangles may be taken for each other.
struct SegmentJudge {
    std::function<std::vector<std::vector<SeenSegment>>(std::size_t position)> nearby;
    std::function<SegmentOracle::Doubt(std::size_t position, double u, std::uint32_t got, std::uint32_t truth)> doubt;
};
SegmentComparison compareSegments(std::span<const std::vector<SeenSegment>> got,
                                  std::span<const std::vector<SeenSegment>> truth, const SegmentTolerance& tolerance,
                                  const SegmentJudge& judge);

/// The same with the oracle's truth at these places, pixels from the lower left corner, and at eight around each.
/// Throws Error where the numbers of lists and places differ.
SegmentComparison compareSegments(const SegmentOracle& oracle, const FramePlan& plan, std::span<const glm::vec2> places,
                                  std::span<const std::vector<SeenSegment>> got,
                                  const SegmentTolerance& tolerance = {});

}  // namespace timeshade
