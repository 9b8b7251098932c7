#include "oracle/embree_scene.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"
#include "oracle/embree_api.h"

namespace timeshade::oracle {

namespace {

constexpr double cutoutSlack = 1e-4;  // of barycentrics: far more than Embree's rounding, and still little

/// The context that Embree hands back to the filter, with what the filter needs to know.
struct FilterContext {
    embree::Context ofEmbree;  // first: Embree knows only this part
    const std::vector<glm::vec4>* positionTexels;
    const CutoutCover* cutouts;
    bool keepsDoubtful;
};

bool isMet(const FilterContext& context, std::uint32_t triangle, float y, float z) {
    const CutoutCover::Cover cover = context.cutouts->at(triangle, {static_cast<double>(y), static_cast<double>(z)},
                                                         context.keepsDoubtful ? cutoutSlack : 0.0);
    return cover.covers || cover.doubtful;
}

bool twoSided(const std::vector<glm::vec4>& positionTexels, std::uint32_t triangle) {
    return positionTexels[std::size_t{triangle} * TRIANGLE_POSITION_TEXELS + 4].z != 0.0f;
}

void rejectOpen(const RTCFilterFunctionNArguments* arguments, unsigned i) {
    const auto& context = *reinterpret_cast<const FilterContext*>(arguments->context);
    const unsigned n = arguments->N;
    const bool met = isMet(context, RTCHitN_primID(arguments->hit, n, i), RTCHitN_u(arguments->hit, n, i),
                           RTCHitN_v(arguments->hit, n, i));
    if (!met) arguments->valid[i] = 0;
}

/// Embree's Ng is (v1 - v0) x (v2 - v0): seen from the front, it points against the ray.
void rejectBacks(const RTCFilterFunctionNArguments* arguments) {
    const auto& context = *reinterpret_cast<const FilterContext*>(arguments->context);
    const unsigned n = arguments->N;
    for (unsigned i = 0; i < n; ++i) {
        if (arguments->valid[i] == 0) continue;
        const float facing = RTCHitN_Ng_x(arguments->hit, n, i) * RTCRayN_dir_x(arguments->ray, n, i) +
                             RTCHitN_Ng_y(arguments->hit, n, i) * RTCRayN_dir_y(arguments->ray, n, i) +
                             RTCHitN_Ng_z(arguments->hit, n, i) * RTCRayN_dir_z(arguments->ray, n, i);
        if (facing > 0.0f && !twoSided(*context.positionTexels, RTCHitN_primID(arguments->hit, n, i)))
            arguments->valid[i] = 0;
        else
            rejectOpen(arguments, i);
    }
}

void rejectExcepted(const RTCFilterFunctionNArguments* arguments) {
    const unsigned n = arguments->N;
    for (unsigned i = 0; i < n; ++i) {
        if (arguments->valid[i] == 0) continue;
        if (RTCHitN_primID(arguments->hit, n, i) == RTCRayN_id(arguments->ray, n, i))
            arguments->valid[i] = 0;
        else
            rejectOpen(arguments, i);
    }
}

void fill(RTCRayHit8& rays, int* valid, const RayPacket& packet) {
    for (int lane = 0; lane < RayPacket::size; ++lane) {
        valid[lane] = packet.active[lane] ? -1 : 0;
        rays.ray.org_x[lane] = packet.from[lane].x;
        rays.ray.org_y[lane] = packet.from[lane].y;
        rays.ray.org_z[lane] = packet.from[lane].z;
        rays.ray.dir_x[lane] = packet.direction[lane].x;
        rays.ray.dir_y[lane] = packet.direction[lane].y;
        rays.ray.dir_z[lane] = packet.direction[lane].z;
        rays.ray.tnear[lane] = packet.low;
        rays.ray.tfar[lane] = packet.high;
        rays.ray.time[lane] = std::clamp(packet.time[lane], 0.0f, 1.0f);  // Embree knows no others
        rays.ray.id[lane] = packet.except[lane];
        rays.ray.mask[lane] = ~0u;
        rays.ray.flags[lane] = 0;
        rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    }
}

PacketHits trace(RTCScene scene, const RayPacket& packet, FilterContext& context, RTCFilterFunctionN filter) {
    alignas(32) RTCRayHit8 rays;
    alignas(32) int valid[RayPacket::size];
    fill(rays, valid, packet);
    embree::firstHits(valid, scene, rays, context.ofEmbree, filter);
    PacketHits hits;
    for (int lane = 0; lane < RayPacket::size; ++lane) {
        hits.hit[lane] = packet.active[lane] && rays.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
        hits.triangle[lane] = hits.hit[lane] ? rays.hit.primID[lane] : NO_TRIANGLE;
        hits.distance[lane] = rays.ray.tfar[lane];
        const float u = rays.hit.u[lane], v = rays.hit.v[lane];
        if (hits.hit[lane] && packet.keepsDoubtful)
            hits.doubtful[lane] =
                context.cutouts->at(hits.triangle[lane], {static_cast<double>(u), static_cast<double>(v)}, cutoutSlack)
                    .doubtful;
        hits.leastBarycentric[lane] = hits.hit[lane] ? std::min({u, v, 1.0f - u - v}) : 0.0f;
    }
    return hits;
}

RTCGeometry makeGeometry(RTCDevice device, const FramePlan& plan) {
    const MeshTopology& topology = *plan.mesh->topology;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryTimeStepCount(geometry, 2);
    for (unsigned step = 0; step < 2; ++step) {
        auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, step, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), topology.vertexCount));
        for (std::size_t i = 0; i < topology.vertexCount; ++i) vertices[i] = plan.texels->vertices[2 * i + step];
    }
    auto* indices = static_cast<glm::u32vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::u32vec3), topology.triangles.size()));
    std::copy(topology.triangles.begin(), topology.triangles.end(), indices);
    rtcCommitGeometry(geometry);
    return geometry;
}

}  // namespace

void EmbreeScene::ReleaseDevice::operator()(RTCDeviceTy* device) const { rtcReleaseDevice(device); }
void EmbreeScene::ReleaseScene::operator()(RTCSceneTy* scene) const { rtcReleaseScene(scene); }

EmbreeScene::EmbreeScene(const FramePlan& plan) : texels_(plan.texels), cutouts_(plan), device_(rtcNewDevice(nullptr)) {
    if (!device_)
        throw Error(fmt::format("Embree: no device (error {})", static_cast<int>(rtcGetDeviceError(nullptr))));
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
    // Watertight edges: a ray between two neighbours meets one of them.
    rtcSetSceneFlags(scene_.get(), static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | embree::filterFlag));
    RTCGeometry geometry = makeGeometry(device_.get(), plan);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_.get());
    if (const RTCError error = rtcGetDeviceError(device_.get()); error != RTC_ERROR_NONE)
        throw Error(fmt::format("Embree: building the scene of {} triangles failed (error {})",
                                plan.mesh->topology->triangles.size(), static_cast<int>(error)));
}

PacketHits EmbreeScene::firstHits(const RayPacket& packet) const {
    FilterContext context{{}, &texels_->positions, &cutouts_, packet.keepsDoubtful};
    return trace(scene_.get(), packet, context, rejectExcepted);
}

PacketHits EmbreeScene::firstSeen(const RayPacket& packet) const {
    FilterContext context{{}, &texels_->positions, &cutouts_, packet.keepsDoubtful};
    return trace(scene_.get(), packet, context, rejectBacks);
}

}  // namespace timeshade::oracle
