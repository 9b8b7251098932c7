#include "measure/embree_baseline.h"

#include <algorithm>
#include <atomic>
#include <thread>

#include "core/error.h"
#include "oracle/embree_api.h"
#include "shared/sample_pattern.shared.h"

namespace timeshade {

namespace {

constexpr int packetSize = 8;

/// Where a primary ray ended: the start of its shadow ray. time < 0 where it hit nothing.
struct RayEnd {
    glm::vec3 position{0.0f};
    float time = -1.0f;
};

/// Both ends of the camera's rays, as floats.
struct Rays {
    explicit Rays(const ViewPlan& view)
        : eye{view.open.eye, view.close.eye},
          corner{view.open.corner, view.close.corner},
          right{view.open.right, view.close.right},
          up{view.open.up, view.close.up} {}
    struct Ends {
        Ends(const glm::dvec3& open, const glm::dvec3& close) : a(open), b(close) {}
        glm::vec3 at(float u) const { return a + (b - a) * u; }
        glm::vec3 a, b;
    };
    Ends eye, corner, right, up;
};

RTCScene buildScene(RTCDevice device, const FramePlan& plan) {
    const MeshTopology& topology = *plan.mesh->topology;
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryTimeStepCount(geometry, 2);
    for (unsigned step = 0; step < 2; ++step) {
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, step, RTC_FORMAT_FLOAT3, 3 * sizeof(float), topology.vertexCount));
        for (std::size_t i = 0; i < topology.vertexCount; ++i)
            for (int c = 0; c < 3; ++c)
                vertices[3 * i + static_cast<std::size_t>(c)] = plan.texels->vertices[2 * i + step][c];
    }
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), topology.triangles.size()));
    for (std::size_t i = 0; i < topology.triangles.size(); ++i)
        for (int c = 0; c < 3; ++c) indices[3 * i + static_cast<std::size_t>(c)] = topology.triangles[i][c];
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
}

}  // namespace

struct EmbreeBaseline::Implementation {
    explicit Implementation(const FramePlan& framePlan)
        : plan(framePlan), rays(plan.camera), device(rtcNewDevice(nullptr)) {
        const std::size_t samples = static_cast<std::size_t>(plan.request.width) *
                                    static_cast<std::size_t>(plan.request.height) * plan.block.strata;
        ids.resize(samples);
        ends.resize(samples);
    }
    ~Implementation() {
        if (scene) rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;

    /// Calls work(x, y, stratum) for every packet, on all threads; a thread takes some rows at a time.
    template <typename Work>
    void forEachPacket(const Work& work) {
        constexpr int rowsPerTask = 2;
        std::atomic<int> nextRow{0};
        const auto run = [&] {
            for (int row = nextRow.fetch_add(rowsPerTask); row < plan.request.height;
                 row = nextRow.fetch_add(rowsPerTask))
                for (int y = row; y < std::min(row + rowsPerTask, plan.request.height); ++y)
                    for (std::uint32_t stratum = 0; stratum < plan.block.strata; ++stratum)
                        for (int x = 0; x < plan.request.width; x += packetSize) work(x, y, stratum);
        };
        std::vector<std::thread> threads;
        for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i) threads.emplace_back(run);
        for (std::thread& thread : threads) thread.join();
    }

    std::size_t indexOf(int x, int y, std::uint32_t stratum) const {
        return (std::size_t{stratum} * static_cast<std::size_t>(plan.request.height) + static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(plan.request.width) +
               static_cast<std::size_t>(x);
    }

    void makePacket(int x, int y, std::uint32_t stratum, RTCRayHit8& packet, int* valid) const {
        for (int lane = 0; lane < packetSize; ++lane) {
            valid[lane] = x + lane < plan.request.width ? -1 : 0;
            const glm::uvec2 pixel(static_cast<unsigned>(x + lane), static_cast<unsigned>(y));
            const glm::vec3 pattern = shared::cameraSample(pixel, plan.block.firstStratum + stratum, plan.block.seed,
                                                           plan.block.pixelCentres);
            const float u = shared::sampleTime(plan.block.timeBase, plan.block.timeScale, stratum, pattern.z);
            const glm::vec2 position = (glm::vec2(pixel) + glm::vec2(pattern)) / plan.camera.block.size;
            const glm::vec3 eye = rays.eye.at(u);
            const glm::vec3 direction = rays.corner.at(u) + position.x * rays.right.at(u) + position.y * rays.up.at(u);
            packet.ray.org_x[lane] = eye.x;
            packet.ray.org_y[lane] = eye.y;
            packet.ray.org_z[lane] = eye.z;
            packet.ray.dir_x[lane] = direction.x;
            packet.ray.dir_y[lane] = direction.y;
            packet.ray.dir_z[lane] = direction.z;
            packet.ray.tnear[lane] = plan.camera.block.nearDistance;
            packet.ray.tfar[lane] = 1e30f;
            packet.ray.time[lane] = u;
            packet.ray.mask[lane] = ~0u;
            packet.ray.flags[lane] = 0;
            packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
        }
    }

    void tracePacket(int x, int y, std::uint32_t stratum) {
        alignas(32) RTCRayHit8 packet;
        alignas(32) int valid[packetSize];
        makePacket(x, y, stratum, packet, valid);
        embree::Context context;
        embree::firstHits(valid, scene, packet, context);
        const std::size_t first = indexOf(x, y, stratum);
        for (int lane = 0; lane < packetSize && valid[lane] != 0; ++lane) {
            const std::size_t i = first + static_cast<std::size_t>(lane);
            const bool hit = packet.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
            ids[i] = hit ? packet.hit.primID[lane] : NO_TRIANGLE;
            const float t = packet.ray.tfar[lane];
            ends[i].position = glm::vec3(packet.ray.org_x[lane] + t * packet.ray.dir_x[lane],
                                         packet.ray.org_y[lane] + t * packet.ray.dir_y[lane],
                                         packet.ray.org_z[lane] + t * packet.ray.dir_z[lane]);
            ends[i].time = hit ? packet.ray.time[lane] : -1.0f;
        }
    }

    std::size_t shadowPacket(int x, int y, std::uint32_t stratum) const {
        alignas(32) RTCRay8 packet;
        alignas(32) int valid[packetSize];
        const bool directional = plan.lightOpen.kind == LightKind::Directional;
        for (int lane = 0; lane < packetSize; ++lane) {
            const RayEnd end = x + lane < plan.request.width ? ends[indexOf(x + lane, y, stratum)] : RayEnd{};
            valid[lane] = end.time >= 0.0f ? -1 : 0;
            const glm::vec3 light =
                glm::mix(glm::vec3(plan.block.lightPositionOpen), glm::vec3(plan.block.lightPositionClose), end.time);
            const glm::vec3 direction = directional ? -glm::mix(glm::vec3(plan.block.lightDirection),
                                                                glm::vec3(plan.block.lightDirectionClose), end.time) *
                                                          plan.light.block.farDistance
                                                    : light - end.position;
            packet.org_x[lane] = end.position.x;
            packet.org_y[lane] = end.position.y;
            packet.org_z[lane] = end.position.z;
            packet.dir_x[lane] = direction.x;
            packet.dir_y[lane] = direction.y;
            packet.dir_z[lane] = direction.z;
            packet.tnear[lane] = 1e-5f;
            packet.tfar[lane] = 1.0f;
            packet.time[lane] = std::max(end.time, 0.0f);
            packet.mask[lane] = ~0u;
            packet.flags[lane] = 0;
        }
        embree::anyHits(valid, scene, packet);
        std::size_t dark = 0;
        for (int lane = 0; lane < packetSize; ++lane) dark += valid[lane] != 0 && packet.tfar[lane] < 0.0f ? 1u : 0u;
        return dark;
    }

    FramePlan plan;
    Rays rays;
    RTCDevice device;
    RTCScene scene = nullptr;
    std::vector<std::uint32_t> ids;
    std::vector<RayEnd> ends;
};

EmbreeBaseline::EmbreeBaseline(const FramePlan& plan) {
    if (plan.cutouts)
        throw Error("embree: its rays would meet whole what alpha cuts out (alphaMode MASK); leave it out here");
    implementation_ = std::make_unique<Implementation>(plan);
}
EmbreeBaseline::~EmbreeBaseline() = default;

void EmbreeBaseline::build() { implementation_->scene = buildScene(implementation_->device, implementation_->plan); }

void EmbreeBaseline::makeRays() {
    std::atomic<int> sink{0};  // keeps the rays from being optimised away
    implementation_->forEachPacket([&](int x, int y, std::uint32_t stratum) {
        alignas(32) RTCRayHit8 packet;
        alignas(32) int valid[packetSize];
        implementation_->makePacket(x, y, stratum, packet, valid);
        if (packet.ray.dir_x[0] > 1e30f) sink.fetch_add(1, std::memory_order_relaxed);
    });
}

const std::vector<std::uint32_t>& EmbreeBaseline::tracePrimaries() {
    implementation_->forEachPacket(
        [&](int x, int y, std::uint32_t stratum) { implementation_->tracePacket(x, y, stratum); });
    return implementation_->ids;
}

std::size_t EmbreeBaseline::traceShadows() {
    std::atomic<std::size_t> dark{0};
    implementation_->forEachPacket([&](int x, int y, std::uint32_t stratum) {
        dark.fetch_add(implementation_->shadowPacket(x, y, stratum), std::memory_order_relaxed);
    });
    return dark;
}

}  // namespace timeshade
