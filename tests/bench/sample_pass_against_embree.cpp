// Is drawing the camera samples slower than tracing them? The sample pass of the built-in scenes against Embree's
// motion-blurred primary rays for the very same camera samples, on the same cores: packets of eight, all threads,
// scene built once and not counted, interleaved frame by frame. Prints medians and their ratio, and checks that both see
// the same triangles. Exit code 1 when the ratio is above 1.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <thread>
#include <vector>

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include "frame/frame_renderer.h"
#include "frame_setup.h"
#include "make_context.h"
#include "report.h"
#include "scene_catalogue.h"
#include "shared/sample_pattern.shared.h"

using namespace timeshade;

namespace {

double milliseconds(std::chrono::steady_clock::time_point since) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - since).count();
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// The plan's mesh as one Embree geometry with two time steps, and the plan's rays.
class PrimaryRays {
  public:
    explicit PrimaryRays(const FramePlan& plan) : plan_(plan) {
        const MeshTopology& topology = *plan.mesh->topology;
        device_ = rtcNewDevice(nullptr);
        scene_ = rtcNewScene(device_);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetGeometryTimeStepCount(geometry, 2);
        for (unsigned step = 0; step < 2; ++step) {
            auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, step, RTC_FORMAT_FLOAT3,
                                                                         3 * sizeof(float), topology.vertexCount));
            for (std::size_t i = 0; i < topology.vertexCount; ++i)
                for (int c = 0; c < 3; ++c) vertices[3 * i + static_cast<std::size_t>(c)] = plan.texels->vertices[2 * i + step][c];
        }
        auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                            3 * sizeof(std::uint32_t), topology.triangles.size()));
        for (std::size_t i = 0; i < topology.triangles.size(); ++i)
            for (int c = 0; c < 3; ++c) indices[3 * i + static_cast<std::size_t>(c)] = topology.triangles[i][c];
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
        ids_.resize(static_cast<std::size_t>(plan.request.width) * static_cast<std::size_t>(plan.request.height) * plan.block.strata);
    }
    ~PrimaryRays() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    PrimaryRays(const PrimaryRays&) = delete;
    PrimaryRays& operator=(const PrimaryRays&) = delete;

    /// Makes the rays of all samples with all threads, a few rows at a time, and traces them unless told otherwise.
    void run(bool trace) {
        trace_ = trace;
        std::atomic<int> nextRow{0};
        const auto work = [&] {
            for (int row = nextRow.fetch_add(rowsPerTask); row < plan_.request.height; row = nextRow.fetch_add(rowsPerTask))
                for (int y = row; y < std::min(row + rowsPerTask, plan_.request.height); ++y) traceRow(y);
        };
        std::vector<std::thread> threads;
        for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i) threads.emplace_back(work);
        for (std::thread& thread : threads) thread.join();
    }

    const std::vector<std::uint32_t>& ids() const { return ids_; }

  private:
    static constexpr int rowsPerTask = 8;

    void traceRow(int y) {
        // Rays of one packet: eight pixels side by side in one stratum, the most coherent order there is.
        for (std::uint32_t stratum = 0; stratum < plan_.block.strata; ++stratum)
            for (int x = 0; x < plan_.request.width; x += 8) tracePacket(x, y, stratum);
    }

    void tracePacket(int x, int y, std::uint32_t stratum) {
        const int width = plan_.request.width;
        alignas(32) RTCRayHit8 packet;
        alignas(32) int valid[8];
        const auto& camera = plan_.camera;
        for (int lane = 0; lane < 8; ++lane) {
            valid[lane] = x + lane < width ? -1 : 0;
            const glm::uvec2 pixel(static_cast<unsigned>(x + lane), static_cast<unsigned>(y));
            const glm::vec3 pattern = shared::samplePattern(pixel, stratum, plan_.block.seed, SALT_CAMERA);
            const float u = shared::sampleTime(plan_.block.timeBase, plan_.block.timeScale, stratum, pattern.z);
            const glm::vec2 position = (glm::vec2(pixel) + glm::vec2(pattern)) / camera.block.size;
            const glm::vec3 eye = glm::mix(eyeOpen_, eyeClose_, u);
            const glm::vec3 direction = glm::mix(cornerOpen_, cornerClose_, u) + position.x * glm::mix(rightOpen_, rightClose_, u) +
                                        position.y * glm::mix(upOpen_, upClose_, u);
            packet.ray.org_x[lane] = eye.x;
            packet.ray.org_y[lane] = eye.y;
            packet.ray.org_z[lane] = eye.z;
            packet.ray.dir_x[lane] = direction.x;
            packet.ray.dir_y[lane] = direction.y;
            packet.ray.dir_z[lane] = direction.z;
            packet.ray.tnear[lane] = camera.block.nearDistance;
            packet.ray.tfar[lane] = 1e30f;
            packet.ray.time[lane] = u;
            packet.ray.mask[lane] = ~0u;
            packet.ray.flags[lane] = 0;
            packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
        }
        if (!trace_) {
            // Kept from being optimised away: what making the rays costs alone.
            sink_.fetch_add(packet.ray.dir_x[0] > 1e30f ? 1 : 0, std::memory_order_relaxed);
            return;
        }
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        rtcIntersect8(valid, scene_, &context, &packet);
        std::uint32_t* out = ids_.data() + (std::size_t{stratum} * static_cast<std::size_t>(plan_.request.height) + static_cast<std::size_t>(y)) *
                                               static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        for (int lane = 0; lane < 8 && x + lane < width; ++lane)
            out[lane] = packet.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID ? NO_TRIANGLE : packet.hit.primID[lane];
    }

    const FramePlan& plan_;
    glm::vec3 eyeOpen_{plan_.camera.open.eye}, eyeClose_{plan_.camera.close.eye};
    glm::vec3 cornerOpen_{plan_.camera.open.corner}, cornerClose_{plan_.camera.close.corner};
    glm::vec3 rightOpen_{plan_.camera.open.right}, rightClose_{plan_.camera.close.right};
    glm::vec3 upOpen_{plan_.camera.open.up}, upClose_{plan_.camera.close.up};
    bool trace_ = true;
    std::atomic<int> sink_{0};
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    std::vector<std::uint32_t> ids_;
};

/// Draws the samples only; the technique is asked for nothing.
class NoShadow final : public Technique {
  public:
    const TechniqueDescription& description() const override {
        static const TechniqueDescription none{"none", "none", "", ""};
        return none;
    }
    void visitSettings(SettingsVisitor&) override {}
    std::vector<PassDecision> passes(const FramePlan&) const override { return {}; }
    void build(const TechniqueFrame&) override {}
    void lookup(const TechniqueFrame&) override {}
    std::vector<const gl::Texture*> textures() const override { return {}; }
    std::size_t bytes() const override { return 0; }
};

double sampleMilliseconds(FrameRenderer& renderer, const FramePlan& plan, Technique& technique) {
    renderer.draw(plan, technique, View::Visibility);
    for (const auto& reading : renderer.timer().finishFrame())
        if (reading.name == "sample") return reading.milliseconds;
    return 0.0;
}

double compare(FrameRenderer& renderer, const std::string& name, int rounds) {
    const std::unique_ptr<Scene> scene = openScene(name, "");
    FramePlanner planner(*scene);
    Options options;
    const FramePlan plan = planner.plan(requestFor(options, *scene));
    NoShadow none;
    PrimaryRays rays(plan);
    std::vector<double> drawn, made, traced;
    for (int round = -2; round < rounds; ++round) {  // two rounds to warm up
        const double a = sampleMilliseconds(renderer, plan, none);
        const auto begin = std::chrono::steady_clock::now();
        rays.run(false);
        const double b = milliseconds(begin);
        const auto beginTracing = std::chrono::steady_clock::now();
        rays.run(true);
        const double c = milliseconds(beginTracing);
        if (round < 0) continue;
        drawn.push_back(a);
        made.push_back(b);
        traced.push_back(c);
    }
    const std::vector<std::uint32_t> ids = renderer.readSampleIds();
    std::size_t different = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) different += ids[i] != rays.ids()[i] ? 1u : 0u;
    const double ratio = median(drawn) / median(traced);
    fmt::print("{:<9} {:>6} triangles  {:>7.1f} ms  {:>7.1f} ms  {:>7.1f} ms  {:>5.2f}   {:>7.1f} ppm differ\n", name, plan.motion.triangles,
               median(drawn), median(traced), median(made), ratio, 1e6 * static_cast<double>(different) / static_cast<double>(ids.size()));
    return ratio;
}

} // namespace

int main(int argumentCount, char** arguments) {
    const int rounds = argumentCount > 1 ? std::max(1, std::atoi(arguments[1])) : 11;
    const std::unique_ptr<GlContext> context = makeContext({}, false);
    FrameRenderer renderer;
    fmt::print("{}, {} threads; 640 x 480, 8 samples per pixel; medians of {} interleaved rounds\n", deviceLine(renderer.device()),
               std::thread::hardware_concurrency(), rounds);
    fmt::print("{:<9} {:>16}  {:>10}  {:>10}  {:>10}  {:>5}\n", "scene", "", "drawn", "Embree", "its rays", "ratio");
    double worst = 0.0;
    for (const BuiltInScene& scene : builtInScenes()) worst = std::max(worst, compare(renderer, scene.name, rounds));
    fmt::print("worst ratio {:.2f}; 1 is as fast as Embree\n", worst);
    return worst <= 1.0 ? 0 : 1;
}
