#include "oracle/oracle.h"

#include <algorithm>
#include <cmath>

#include "oracle/camera_rays.h"
#include "oracle/embree_scene.h"
#include "oracle/parallel_rows.h"
#include "oracle/resolve_primary.h"
#include "oracle/resolve_shadow.h"

namespace timeshade {

using namespace oracle;

namespace {

// Hits of Embree that its own floats might have got wrong are ruled upon: those this near to an edge, to the receiver
// or to the light. Far more than its rounding, and still few.
constexpr float doubtfulBarycentric = 1e-3f;
constexpr float doubtfulDistance = 1e-4f;

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
    forEachRow(plan.block.imageSize.y, [&](std::uint32_t y) {
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

struct Oracle::Implementation {
    explicit Implementation(const FramePlan& plan)
        : texels(plan.texels), embree(plan), triangles(texels->positions), bvh(triangles) {}

    std::shared_ptr<const MeshTexels> texels;
    EmbreeScene embree;
    MovingTriangles triangles;
    SweptBvh bvh;

    OracleAnswer rule(const Receiver& receiver, std::uint32_t triangle) const {
        OracleAnswer answer = receiver.answer;
        if (!answer.tested) return answer;
        const ResolvedShadow resolved =
            resolveShadow(bvh, triangles, answer.position, receiver.light, triangle, static_cast<double>(answer.time));
        answer.lit = resolved.lit;
        answer.marginal = answer.marginal || resolved.marginal;
        return answer;
    }

    void answerPacket(const FramePlan& plan, SampleIndex first, const std::uint32_t* ids, OracleAnswer* answers) const {
        Receiver receivers[RayPacket::size];
        RayPacket packet;
        packet.low = static_cast<float>(nearestCaster);
        bool any = false;
        for (int lane = 0; lane < lanesOf(plan, first); ++lane) {
            Receiver& receiver = receivers[lane];
            receiver = receiverOf(plan, triangles, laneOf(first, lane), ids[lane]);
            packet.active[lane] = receiver.answer.tested;
            packet.from[lane] = glm::vec3(receiver.answer.position);
            packet.direction[lane] = glm::vec3(receiver.light - receiver.answer.position);
            packet.time[lane] = receiver.answer.time;
            any = any || receiver.answer.tested;
        }
        PacketHits hits;
        if (any) hits = embree.firstHits(packet);
        for (int lane = 0; lane < lanesOf(plan, first); ++lane) {
            answers[lane] = receivers[lane].answer;
            if (!packet.active[lane]) continue;
            const bool doubtful =
                hits.hit[lane] &&
                (hits.triangle[lane] == ids[lane] || hits.distance[lane] < doubtfulDistance ||
                 hits.distance[lane] > 1.0f - doubtfulDistance || hits.leastBarycentric[lane] < doubtfulBarycentric);
            if (doubtful)
                answers[lane] = rule(receivers[lane], ids[lane]);
            else
                answers[lane].lit = !hits.hit[lane];
        }
    }

    void tracePacket(const FramePlan& plan, SampleIndex first, std::uint32_t* ids) const {
        RayPacket packet;
        packet.low = plan.camera.block.nearDistance;
        packet.high = 1e30f;
        for (int lane = 0; lane < lanesOf(plan, first); ++lane) {
            const CameraRay ray = cameraRay(plan, laneOf(first, lane));
            packet.active[lane] = true;
            packet.from[lane] = glm::vec3(ray.eye);
            packet.direction[lane] = glm::vec3(ray.direction);
            packet.time[lane] = static_cast<float>(ray.time);
        }
        const PacketHits hits = embree.firstSeen(packet);
        std::copy(hits.triangle, hits.triangle + lanesOf(plan, first), ids);
    }
};

Oracle::Oracle(const FramePlan& plan) : implementation_(std::make_unique<Implementation>(plan)) {}
Oracle::~Oracle() = default;

std::vector<OracleAnswer> Oracle::answer(const FramePlan& plan, std::span<const std::uint32_t> triangles) const {
    std::vector<OracleAnswer> answers(sampleCount(plan));
    forEachPacket(plan, [&](SampleIndex first) {
        const std::size_t i = indexOf(plan, first);
        implementation_->answerPacket(plan, first, triangles.data() + i, answers.data() + i);
    });
    return answers;
}

std::vector<OracleAnswer> Oracle::resolveAll(const FramePlan& plan, std::span<const std::uint32_t> triangles) const {
    std::vector<OracleAnswer> answers(sampleCount(plan));
    forEachPacket(plan, [&](SampleIndex first) {
        const std::size_t i = indexOf(plan, first);
        for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanesOf(plan, first)); ++lane)
            answers[i + lane] = rule(plan, laneOf(first, static_cast<int>(lane)), triangles[i + lane]);
    });
    return answers;
}

std::vector<std::uint32_t> Oracle::tracePrimaries(const FramePlan& plan) const {
    std::vector<std::uint32_t> ids(sampleCount(plan), NO_TRIANGLE);
    forEachPacket(
        plan, [&](SampleIndex first) { implementation_->tracePacket(plan, first, ids.data() + indexOf(plan, first)); });
    return ids;
}

OracleAnswer Oracle::rule(const FramePlan& plan, SampleIndex sample, std::uint32_t triangle) const {
    return implementation_->rule(receiverOf(plan, implementation_->triangles, sample, triangle), triangle);
}

Oracle::ResolvedPrimary Oracle::resolvePrimary(const FramePlan& plan, SampleIndex sample) const {
    return resolveFirstSeen(implementation_->bvh, implementation_->triangles, cameraRay(plan, sample),
                            static_cast<double>(plan.camera.block.nearDistance));
}

}  // namespace timeshade
