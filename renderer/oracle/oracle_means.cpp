// The oracle's means of visibility over time and area: plain stratified sampling, a hash for random numbers.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "oracle/implementation.h"
#include "oracle/parallel_rows.h"
#include "shared/sample_pattern.shared.h"
#include "shared/shutter_response.shared.h"

namespace timeshade {

using namespace oracle;

namespace {

/// Each call gets the numbers of the next so many rays of the domain, the last one maybe fewer.
template <class Work>
void forEachLanes(std::uint32_t rays, const Work& work) {
    for (std::uint32_t first = 0; first < rays; first += RayPacket::size)
        work(first, static_cast<int>(std::min<std::uint32_t>(RayPacket::size, rays - first)));
}

void count(const FramePlan& plan, const Receiver* receivers, int lanes, VisibilityMean& mean) {
    for (int lane = 0; lane < lanes; ++lane) {
        const OracleAnswer& answer = receivers[lane].answer;
        if (!answer.tested) continue;
        const float weight = shared::shutterWeight(plan.block.response, plan.block.responseWidth, answer.time);
        mean.add(answer.lit, static_cast<double>(weight));
    }
}

/// Place in the pixel and time of the rays of one domain: one ray in each of so many strata of its time.
class RayPattern {
  public:
    RayPattern(glm::uvec2 pixel, float from, float to, std::uint32_t rays, std::uint32_t seed)
        : pixel_(pixel), from_(from), to_(to), step_((to - from) / static_cast<float>(rays)), seed_(seed) {}

    float time(std::uint32_t ray) const { return timeOf(ray, pattern(ray)); }
    CameraRay cameraRay(const FramePlan& plan, std::uint32_t ray) const {
        const glm::vec3 place = pattern(ray);
        return cameraRayThrough(plan, glm::vec2(pixel_) + glm::vec2(place), timeOf(ray, place));
    }

  private:
    glm::vec3 pattern(std::uint32_t ray) const { return shared::samplePattern(pixel_, ray, seed_, SALT_CAMERA); }
    float timeOf(std::uint32_t ray, const glm::vec3& pattern) const {
        return std::min(shared::sampleTime(from_, step_, ray, pattern.z), to_);
    }

    glm::uvec2 pixel_;
    float from_, to_, step_;
    std::uint32_t seed_;
};

VisibilityMean meanOfPixel(const Oracle::Implementation& oracle, const FramePlan& plan, const RayPattern& pattern,
                           std::uint32_t rays, const std::uint32_t* instance) {
    const auto& instances = oracle.mesh->topology->triangleInstances;
    VisibilityMean mean;
    forEachLanes(rays, [&](std::uint32_t first, int lanes) {
        CameraRay cameraRays[RayPacket::size];
        std::uint32_t ids[RayPacket::size];
        Receiver receivers[RayPacket::size];
        for (int lane = 0; lane < lanes; ++lane)
            cameraRays[lane] = pattern.cameraRay(plan, first + static_cast<std::uint32_t>(lane));
        oracle.traceLanes(plan, cameraRays, ids, lanes);
        for (int lane = 0; lane < lanes; ++lane) {
            if (ids[lane] == NO_TRIANGLE || (instance && instances[ids[lane]] != *instance)) continue;
            receivers[lane] = receiverOf(plan, oracle.triangles, cameraRays[lane], ids[lane]);
        }
        oracle.testLanes(receivers, ids, lanes, Oracle::Implementation::Edges::AsEmbreeSays);
        count(plan, receivers, lanes, mean);
    });
    return mean;
}

VisibilityMean meanOfPoint(const Oracle::Implementation& oracle, const FramePlan& plan, const SampleFootprint& over,
                           const RayPattern& pattern, std::uint32_t rays) {
    const Receiver seen = receiverOf(plan, oracle.triangles, over.sample, over.triangle);
    const glm::dvec2 barycentrics =
        barycentricsOf(oracle.triangles, over.triangle, seen.answer.position, static_cast<double>(seen.answer.time));
    VisibilityMean mean;
    if (!std::isfinite(barycentrics.x) || !std::isfinite(barycentrics.y)) return mean;
    std::uint32_t ids[RayPacket::size];
    std::fill(std::begin(ids), std::end(ids), over.triangle);
    forEachLanes(rays, [&](std::uint32_t first, int lanes) {
        Receiver receivers[RayPacket::size];
        for (int lane = 0; lane < lanes; ++lane)
            receivers[lane] = receiverOnTriangle(plan, oracle.triangles, over.triangle, barycentrics,
                                                 pattern.time(first + static_cast<std::uint32_t>(lane)));
        oracle.testLanes(receivers, ids, lanes, Oracle::Implementation::Edges::AsEmbreeSays);
        count(plan, receivers, lanes, mean);
    });
    return mean;
}

}  // namespace

std::vector<VisibilityMean> Oracle::pixelMeans(const FramePlan& plan, std::uint32_t firstRow, std::uint32_t rows,
                                               std::uint32_t rays, std::uint32_t seed) const {
    const std::uint32_t width = plan.block.imageSize.x;
    std::vector<VisibilityMean> means(std::size_t{width} * rows);
    forEachPausing(rows, 4, [&](std::size_t i) {
        const auto row = static_cast<std::uint32_t>(i);
        for (std::uint32_t x = 0; x < width; ++x) {
            const RayPattern pattern({x, firstRow + row}, 0.0f, 1.0f, rays, seed);
            means[std::size_t{row} * width + x] = meanOfPixel(*implementation_, plan, pattern, rays, nullptr);
        }
    });
    return means;
}

std::vector<VisibilityMean> Oracle::footprintMeans(const FramePlan& plan, std::span<const SampleFootprint> footprints,
                                                   std::uint32_t rays, std::uint32_t seed) const {
    const auto& instances = implementation_->mesh->topology->triangleInstances;
    std::vector<VisibilityMean> means(footprints.size());
    forEachPausing(footprints.size(), 4, [&](std::size_t i) {
        const SampleFootprint& over = footprints[i];
        if (over.triangle >= instances.size()) return;
        // Two samples of a pixel share no random numbers.
        const RayPattern pattern(
            {over.sample.x, over.sample.y}, over.from, over.to, rays,
            shared::hashWords({seed, plan.block.firstStratum + over.sample.stratum, 0x8f1bbcdcu}).x);
        means[i] = over.space == SampleFootprint::Space::Point
                       ? meanOfPoint(*implementation_, plan, over, pattern, rays)
                       : meanOfPixel(*implementation_, plan, pattern, rays, &instances[over.triangle]);
    });
    return means;
}

}  // namespace timeshade
