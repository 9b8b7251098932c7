#include "measure/segment_comparison.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/check.h"
#include "core/error.h"

namespace timeshade {

namespace {

using Cause = SegmentDisagreement::Cause;
using Lists = std::span<const std::vector<SeenSegment>>;

/// Goes over [0, 1] in pieces in which no list changes.
template <class Visit>
void forEachPiece(std::span<const SeenSegment> got, Lists truths, const Visit& visit) {
    std::vector<double> cuts;
    for (const SeenSegment& s : got) cuts.push_back(s.u1);
    for (const std::vector<SeenSegment>& truth : truths)
        for (const SeenSegment& s : truth) cuts.push_back(s.u1);
    std::sort(cuts.begin(), cuts.end());
    double begin = 0.0;
    for (const double end : cuts) {
        if (end > begin) visit(begin, end);
        begin = std::max(begin, end);
    }
}

bool isAnyOf(Lists truths, double u, std::uint32_t triangle) {
    return std::any_of(truths.begin(), truths.end(),
                       [&](const std::vector<SeenSegment>& truth) { return seenAt(truth, u) == triangle; });
}

Cause causeOf(SegmentOracle::Doubt doubt) {
    if (doubt == SegmentOracle::Doubt::EdgeOn) return Cause::EdgeOn;
    return doubt == SegmentOracle::Doubt::DepthTie ? Cause::DepthTie : Cause::Different;
}

double differingTimeOf(std::span<const SeenSegment> got, const std::vector<SeenSegment>& truth) {
    double sum = 0.0;
    for (const SeenSegment& part : differingParts(got, Lists(&truth, 1), 0.0)) sum += part.u1 - part.u0;
    return sum;
}

}  // namespace

std::size_t SegmentComparison::count(Cause cause) const {
    return static_cast<std::size_t>(std::count_if(disagreements.begin(), disagreements.end(),
                                                  [&](const SegmentDisagreement& d) { return d.cause == cause; }));
}

double SegmentComparison::partsPerMillion() const {
    const std::size_t wrong = count(Cause::Different) + count(Cause::Malformed);
    return positions == 0 ? 0.0 : 1e6 * static_cast<double>(wrong) / static_cast<double>(positions);
}

bool isPartition(std::span<const SeenSegment> segments) {
    if (segments.empty() || !(segments.front().u0 == 0.0) || !(segments.back().u1 == 1.0)) return false;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (!(segments[i].u0 <= segments[i].u1)) return false;
        if (i > 0 && !(segments[i].u0 == segments[i - 1].u1)) return false;
    }
    return true;
}

std::uint32_t seenAt(std::span<const SeenSegment> segments, double u) {
    CHECK(!segments.empty());
    for (const SeenSegment& s : segments)
        if (u < s.u1) return s.triangle;
    return segments.back().triangle;
}

std::vector<SeenSegment> differingParts(std::span<const SeenSegment> got, Lists truths, double time) {
    std::vector<SeenSegment> parts;
    double longestPiece = 0.0;
    forEachPiece(got, truths, [&](double begin, double end) {
        const double middle = 0.5 * (begin + end);
        const std::uint32_t triangle = seenAt(got, middle);
        if (isAnyOf(truths, middle, triangle)) return;
        if (parts.empty() || parts.back().u1 != begin) {
            parts.push_back({triangle, begin, end});
            longestPiece = 0.0;
        }
        parts.back().u1 = end;
        if (end - begin <= longestPiece) return;
        longestPiece = end - begin;
        parts.back().triangle = triangle;
    });
    std::erase_if(parts, [&](const SeenSegment& part) { return part.u1 - part.u0 <= time; });
    return parts;
}

SegmentComparison compareSegments(Lists got, Lists truth, const SegmentTolerance& tolerance,
                                  const SegmentJudge& judge) {
    if (got.size() != truth.size())
        throw Error(fmt::format("cannot compare segments: those of {} positions with those of {}, expected as many",
                                got.size(), truth.size()));
    SegmentComparison result;
    result.positions = got.size();
    for (std::size_t i = 0; i < got.size(); ++i) {
        if (!isPartition(got[i])) {
            result.disagreements.push_back({i, Cause::Malformed, 0.0, 1.0, NO_TRIANGLE, NO_TRIANGLE});
            continue;
        }
        result.differingTime += differingTimeOf(got[i], truth[i]);
        if (differingParts(got[i], Lists(&truth[i], 1), tolerance.time).empty()) continue;
        std::vector<std::vector<SeenSegment>> around = judge.nearby(i);
        around.push_back(truth[i]);
        const std::vector<SeenSegment> parts = differingParts(got[i], around, tolerance.time);
        if (parts.empty()) {
            ++result.beside;
            continue;
        }
        const SeenSegment longest =
            *std::max_element(parts.begin(), parts.end(),
                              [](const SeenSegment& a, const SeenSegment& b) { return a.u1 - a.u0 < b.u1 - b.u0; });
        const double middle = 0.5 * (longest.u0 + longest.u1);
        const std::uint32_t seen = seenAt(got[i], middle), expected = seenAt(truth[i], middle);
        result.disagreements.push_back(
            {i, causeOf(judge.doubt(i, middle, seen, expected)), longest.u0, longest.u1, seen, expected});
    }
    return result;
}

SegmentComparison compareSegments(const SegmentOracle& oracle, const FramePlan& plan, std::span<const glm::vec2> places,
                                  Lists got, const SegmentTolerance& tolerance) {
    SegmentJudge judge;
    judge.nearby = [&](std::size_t i) {
        std::vector<std::vector<SeenSegment>> around;
        for (int k = 0; k < 8; ++k) {
            const double angle = k * std::acos(-1.0) / 4.0;
            around.push_back(
                oracle.seenBy(plan, places[i], tolerance.pixels * glm::dvec2(std::cos(angle), std::sin(angle))));
        }
        return around;
    };
    judge.doubt = [&](std::size_t i, double u, std::uint32_t seen, std::uint32_t truth) {
        return oracle.doubtBetween(plan, places[i], u, seen, truth);
    };
    return compareSegments(got, oracle.seenByAll(plan, places), tolerance, judge);
}

}  // namespace timeshade
