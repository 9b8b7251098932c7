#include "oracle/oracle.h"

#include <algorithm>

#include "oracle/implementation.h"
#include "oracle/parallel_rows.h"
#include "oracle/resolve_primary.h"

namespace timeshade {

using namespace oracle;

namespace {

std::size_t indexOf(const FramePlan& plan, SampleIndex sample) {
    const glm::uvec2 size = plan.block.imageSize;
    return (std::size_t{sample.stratum} * size.y + sample.y) * size.x + sample.x;
}

std::size_t sampleCount(const FramePlan& plan) {
    return std::size_t{plan.block.imageSize.x} * plan.block.imageSize.y * plan.block.strata;
}

/// Calls work(first) for each packet of samples side by side in a row, all strata.
template <class Work>
void forEachPacket(const FramePlan& plan, const Work& work) {
    forEachPausing(plan.block.imageSize.y, 4, [&](std::size_t row) {
        const auto y = static_cast<std::uint32_t>(row);
        for (std::uint32_t stratum = 0; stratum < plan.block.strata; ++stratum)
            for (std::uint32_t x = 0; x < plan.block.imageSize.x; x += RayPacket::size)
                work(SampleIndex{x, y, stratum});
    });
}

int lanesOf(const FramePlan& plan, SampleIndex first) {
    return static_cast<int>(std::min<std::uint32_t>(RayPacket::size, plan.block.imageSize.x - first.x));
}

SampleIndex laneOf(SampleIndex first, int lane) {
    return {first.x + static_cast<std::uint32_t>(lane), first.y, first.stratum};
}

}  // namespace

Oracle::Oracle(const FramePlan& plan) : implementation_(std::make_unique<Implementation>(plan)) {}
Oracle::~Oracle() = default;

std::vector<OracleAnswer> Oracle::answer(const FramePlan& plan, std::span<const std::uint32_t> triangles) const {
    std::vector<OracleAnswer> answers(sampleCount(plan));
    forEachPacket(plan, [&](SampleIndex first) {
        const std::size_t i = indexOf(plan, first);
        const int lanes = lanesOf(plan, first);
        Receiver receivers[RayPacket::size];
        for (int lane = 0; lane < lanes; ++lane)
            receivers[lane] = receiverOf(plan, implementation_->triangles, laneOf(first, lane),
                                         triangles[i + static_cast<std::size_t>(lane)]);
        implementation_->testLanes(receivers, triangles.data() + i, lanes, Implementation::Edges::ResolvedExactly);
        for (int lane = 0; lane < lanes; ++lane) answers[i + static_cast<std::size_t>(lane)] = receivers[lane].answer;
    });
    return answers;
}

std::vector<OracleAnswer> Oracle::resolveAll(const FramePlan& plan, std::span<const std::uint32_t> triangles) const {
    std::vector<OracleAnswer> answers(sampleCount(plan));
    forEachPacket(plan, [&](SampleIndex first) {
        const std::size_t i = indexOf(plan, first);
        for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanesOf(plan, first)); ++lane)
            answers[i + lane] = resolve(plan, laneOf(first, static_cast<int>(lane)), triangles[i + lane]);
    });
    return answers;
}

std::vector<std::uint32_t> Oracle::tracePrimaries(const FramePlan& plan) const {
    std::vector<std::uint32_t> ids(sampleCount(plan), NO_TRIANGLE);
    forEachPacket(plan, [&](SampleIndex first) {
        CameraRay rays[RayPacket::size];
        for (int lane = 0; lane < lanesOf(plan, first); ++lane) rays[lane] = cameraRay(plan, laneOf(first, lane));
        implementation_->traceLanes(plan, rays, ids.data() + indexOf(plan, first), lanesOf(plan, first));
    });
    return ids;
}

OracleAnswer Oracle::resolve(const FramePlan& plan, SampleIndex sample, std::uint32_t triangle) const {
    return implementation_->resolve(receiverOf(plan, implementation_->triangles, sample, triangle), triangle);
}

Oracle::ResolvedPrimary Oracle::resolvePrimary(const FramePlan& plan, SampleIndex sample) const {
    return resolveFirstSeen(implementation_->bvh, implementation_->triangles, cameraRay(plan, sample),
                            static_cast<double>(plan.camera.block.nearDistance), &implementation_->cutouts);
}

}  // namespace timeshade
