#include "oracle/implementation.h"

#include <algorithm>

#include "oracle/resolve_shadow.h"

namespace timeshade {

using namespace oracle;

namespace {

// Far more than Embree's rounding, and still few.
constexpr float doubtfulBarycentric = 1e-3f;
constexpr float doubtfulDistance = 1e-4f;

}  // namespace

Oracle::Implementation::Implementation(const FramePlan& plan)
    : texels(plan.texels), mesh(plan.mesh), cutouts(plan), embree(plan), triangles(texels->positions), bvh(triangles) {}

OracleAnswer Oracle::Implementation::resolve(const Receiver& receiver, std::uint32_t triangle) const {
    OracleAnswer answer = receiver.answer;
    if (!answer.tested) return answer;
    const ResolvedShadow resolved = resolveShadow(bvh, triangles, answer.position, receiver.light, receiver.clearance,
                                                  triangle, static_cast<double>(answer.time), &cutouts);
    answer.lit = resolved.lit;
    answer.marginal = answer.marginal || resolved.marginal;
    return answer;
}

void Oracle::Implementation::testLanes(Receiver* receivers, const std::uint32_t* ids, int lanes, Edges edges) const {
    RayPacket packet;
    bool any = false;
    for (int lane = 0; lane < lanes; ++lane) {
        const Receiver& receiver = receivers[lane];
        packet.active[lane] = receiver.answer.tested;
        packet.from[lane] = glm::vec3(receiver.answer.position);
        packet.direction[lane] = glm::vec3(receiver.light - receiver.answer.position);
        packet.time[lane] = receiver.answer.time;
        packet.except[lane] = ids[lane];  // a rounded point lies behind its own plane as often as not
        any = any || receiver.answer.tested;
    }
    if (!any) return;
    packet.keepsDoubtful = edges == Edges::ResolvedExactly;
    const PacketHits hits = embree.firstHits(packet);
    const float nearEdge = edges == Edges::ResolvedExactly ? doubtfulBarycentric : 0.0f;
    for (int lane = 0; lane < lanes; ++lane) {
        if (!packet.active[lane]) continue;
        const bool doubtful =
            hits.hit[lane] && (hits.doubtful[lane] || hits.distance[lane] < doubtfulDistance ||
                               hits.distance[lane] > 1.0f - doubtfulDistance || hits.leastBarycentric[lane] < nearEdge);
        if (doubtful)
            receivers[lane].answer = resolve(receivers[lane], ids[lane]);
        else
            receivers[lane].answer.lit = !hits.hit[lane];
    }
}

void Oracle::Implementation::traceLanes(const FramePlan& plan, const CameraRay* rays, std::uint32_t* ids,
                                        int lanes) const {
    RayPacket packet;
    packet.low = plan.camera.block.nearDistance;
    packet.high = 1e30f;
    for (int lane = 0; lane < lanes; ++lane) {
        packet.active[lane] = true;
        packet.from[lane] = glm::vec3(rays[lane].eye);
        packet.direction[lane] = glm::vec3(rays[lane].direction);
        packet.time[lane] = static_cast<float>(rays[lane].time);
    }
    const PacketHits hits = embree.firstSeen(packet);
    std::copy(hits.triangle, hits.triangle + lanes, ids);
}

}  // namespace timeshade
