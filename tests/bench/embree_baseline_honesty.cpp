// Checks that the times that `measure` reports for Embree are what Embree can do. EmbreeBaseline, which generates its
// rays and stores its hits, is compared with a bare loop: the same rays, prepared in memory, through rtcIntersect8 and
// rtcOccluded8 on all threads. Rounds are interleaved. Exit code 1 if the baseline's minimum time is more than 20 %
// above the bare loop's. On a busy machine the minimum of few rounds is unreliable, so up to four times as many are run
// first.
#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "frame_setup.h"
#include "measure/embree_baseline.h"
#include "oracle/embree_api.h"
#include "scene_catalogue.h"
#include "shared/sample_pattern.shared.h"
#include "timing.h"

using namespace timeshade;

namespace {

constexpr int rounds = 25, maxRounds = 4 * rounds;
constexpr double allowed = 1.2;

struct alignas(32) Packet {
    RTCRayHit8 rays;
    int valid[8];
};

/// Whatever else the machine does only ever adds to a time.
double least(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

void onAllThreads(std::size_t count, const auto& work) {
    std::atomic<std::size_t> next{0};
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
        threads.emplace_back([&] {
            for (std::size_t first = next.fetch_add(64); first < count; first = next.fetch_add(64))
                for (std::size_t p = first; p < std::min(first + 64, count); ++p) work(p);
        });
    for (std::thread& thread : threads) thread.join();
}

RTCScene buildScene(RTCDevice device, const FramePlan& plan) {
    RTCScene scene = rtcNewScene(device);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryTimeStepCount(geometry, 2);
    const std::size_t count = plan.mesh->topology->vertexCount;
    // Both ends lie side by side in the plan's vertices.
    for (unsigned end = 0; end < 2; ++end) {
        auto* out = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, end,
                                                                    RTC_FORMAT_FLOAT3, sizeof(glm::vec3), count));
        for (std::size_t i = 0; i < count; ++i) out[i] = plan.texels->vertices[2 * i + end];
    }
    const auto& triangles = plan.mesh->topology->triangles;
    auto* indices = static_cast<glm::u32vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::u32vec3), triangles.size()));
    std::copy(triangles.begin(), triangles.end(), indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
}

/// The primary rays of all camera samples, eight neighbours of a row to a packet. The camera stands still here.
std::vector<Packet> primaryPackets(const FramePlan& plan) {
    std::vector<Packet> packets;
    for (int y = 0; y < plan.request.height; ++y)
        for (std::uint32_t stratum = 0; stratum < plan.block.strata; ++stratum)
            for (int x = 0; x < plan.request.width; x += 8) {
                Packet& packet = packets.emplace_back();
                for (int lane = 0; lane < 8; ++lane) {
                    const glm::uvec2 pixel(static_cast<unsigned>(x + lane), static_cast<unsigned>(y));
                    const glm::vec3 pattern =
                        shared::cameraSample(pixel, stratum, plan.block.seed, plan.block.pixelCentres);
                    const glm::dvec2 at =
                        (glm::dvec2(pixel) + glm::dvec2(pattern)) / glm::dvec2(plan.camera.block.size);
                    const glm::vec3 from(plan.camera.open.eye),
                        along(plan.camera.open.corner + at.x * plan.camera.open.right + at.y * plan.camera.open.up);
                    RTCRay8& ray = packet.rays.ray;
                    packet.valid[lane] = x + lane < plan.request.width ? -1 : 0;
                    ray.org_x[lane] = from.x, ray.org_y[lane] = from.y, ray.org_z[lane] = from.z;
                    ray.dir_x[lane] = along.x, ray.dir_y[lane] = along.y, ray.dir_z[lane] = along.z;
                    ray.tnear[lane] = plan.camera.block.nearDistance, ray.tfar[lane] = 1e30f;
                    ray.time[lane] = shared::sampleTime(plan.block.timeBase, plan.block.timeScale, stratum, pattern.z);
                    ray.mask[lane] = ~0u, ray.flags[lane] = 0, packet.rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
                }
            }
    return packets;
}

/// From what the primary rays have hit to the light.
std::vector<Packet> shadowPackets(const FramePlan& plan, const std::vector<Packet>& primaries) {
    std::vector<Packet> packets = primaries;
    for (Packet& packet : packets)
        for (int lane = 0; lane < 8; ++lane) {
            RTCRay8& ray = packet.rays.ray;
            if (packet.rays.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) packet.valid[lane] = 0;
            const float t = packet.valid[lane] != 0 ? ray.tfar[lane] : 0.0f;
            const glm::vec3 from(ray.org_x[lane] + t * ray.dir_x[lane], ray.org_y[lane] + t * ray.dir_y[lane],
                                 ray.org_z[lane] + t * ray.dir_z[lane]);
            const glm::vec3 along = glm::mix(glm::vec3(plan.block.lightPositionOpen),
                                             glm::vec3(plan.block.lightPositionClose), ray.time[lane]) -
                                    from;
            ray.org_x[lane] = from.x, ray.org_y[lane] = from.y, ray.org_z[lane] = from.z;
            ray.dir_x[lane] = along.x, ray.dir_y[lane] = along.y, ray.dir_z[lane] = along.z;
            ray.tnear[lane] = 1e-5f, ray.tfar[lane] = 1.0f;
        }
    return packets;
}

double ratioOf(const std::vector<double>& baseline, const std::vector<double>& bare) {
    return least(baseline) / least(bare);
}

void print(const char* what, const std::vector<double>& bare, const std::vector<double>& baseline) {
    fmt::print("{:<10} bare loop {:>7.2f} ms, baseline {:>7.2f} ms, ratio {:.2f} (at most {:.1f}), {} rounds\n", what,
               least(bare), least(baseline), ratioOf(baseline, bare), allowed, bare.size());
}

}  // namespace

int main() {
    const std::unique_ptr<Scene> scene = openScene("pillars", "");
    FrameOptions options;
    options.width = 320;
    options.height = 240;
    FramePlanner planner(*scene);
    const FramePlan plan = planner.plan(requestFor(options, *scene));
    EmbreeBaseline baseline(plan);
    baseline.build();
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene bareScene = buildScene(device, plan);

    const std::vector<Packet> fresh = primaryPackets(plan);
    std::vector<double> bareFirst, baselineFirst, bareShadow, baselineShadow;
    const auto honest = [&] {
        return ratioOf(baselineFirst, bareFirst) <= allowed && ratioOf(baselineShadow, bareShadow) <= allowed;
    };
    for (int round = -1; round < maxRounds; ++round) {  // the first warms up
        if (round > 0 && round % rounds == 0 && honest()) break;
        std::vector<Packet> packets = fresh;
        const double a = millisecondsOf([&] {
            onAllThreads(packets.size(), [&](std::size_t p) {
                embree::Context context;
                embree::firstHits(packets[p].valid, bareScene, packets[p].rays, context);
            });
        });
        const double b = millisecondsOf([&] { baseline.tracePrimaries(); });
        std::vector<Packet> shadows = shadowPackets(plan, packets);
        const double c = millisecondsOf([&] {
            onAllThreads(shadows.size(),
                         [&](std::size_t p) { embree::anyHits(shadows[p].valid, bareScene, shadows[p].rays.ray); });
        });
        const double d = millisecondsOf([&] { baseline.traceShadows(); });
        if (round < 0) continue;
        bareFirst.push_back(a), baselineFirst.push_back(b), bareShadow.push_back(c), baselineShadow.push_back(d);
    }
    rtcReleaseScene(bareScene);
    rtcReleaseDevice(device);
    print("primaries", bareFirst, baselineFirst);
    print("shadows", bareShadow, baselineShadow);
    return honest() ? 0 : 1;
}
