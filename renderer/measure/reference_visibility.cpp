#include "measure/reference_visibility.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "measure/reference_digest.h"
#include "oracle/embree_scene.h"
#include "shared/shutter_response.shared.h"

namespace timeshade {

namespace {

// Seeds of their own, so that no image under test shares its noise with the reference.
constexpr std::uint32_t firstSeed = 0x7ef10001u, secondSeed = 0x7ef20002u;
constexpr int rowsPerStep = 16;

int wholePackets(int rays) {
    constexpr int both = 2 * oracle::RayPacket::size;
    return std::max(1, (rays + both - 1) / both) * both;
}

void digestLight(const LightPose& light, ReferenceDigest& digest) {
    digest.value(light.kind);
    digest.value(light.position);
    digest.value(light.axes);
    digest.value(light.outerConeAngle);
}

float valueOf(const VisibilityMean& mean) {
    return mean.exists() ? static_cast<float>(mean.value()) : ReferenceVisibility::NONE;
}

}  // namespace

std::string referenceVisibilityKey(const FramePlan& plan, int rays) {
    ReferenceDigest digest;
    digest.values(plan.texels->positions);
    digest.value(plan.origin);
    digest.value(plan.camera.open);
    digest.value(plan.camera.close);
    digest.value(plan.camera.block.nearDistance);
    digestLight(plan.lightOpen, digest);
    digestLight(plan.lightClose, digest);
    digest.value(plan.light.block.farDistance);
    // Nothing is said of a box, so that its key is the one that it has always had.
    if (plan.block.response != SHUTTER_BOX) {
        digest.value(plan.block.response);
        digest.value(plan.block.responseWidth);
    }
    return fmt::format("converged visibility 2; frame {}; {} x {}; {} rays", digest.text(), plan.request.width,
                       plan.request.height, wholePackets(rays));
}

ReferenceVisibilityBuilder::ReferenceVisibilityBuilder(FramePlan plan, int rays, const ReferenceCache& cache)
    : plan_(std::move(plan)),
      cache_(cache),
      key_(referenceVisibilityKey(plan_, rays)),
      result_(std::make_shared<ReferenceVisibility>()) {
    result_->width = plan_.request.width;
    result_->height = plan_.request.height;
    result_->rays = wholePackets(rays);
}

ReferenceVisibilityBuilder::~ReferenceVisibilityBuilder() = default;

bool ReferenceVisibilityBuilder::step() {
    if (complete_) return true;
    if (!soughtInCache_) {
        soughtInCache_ = true;
        return complete_ = load();
    }
    if (!oracle_) oracle_ = std::make_unique<Oracle>(plan_);
    const auto first = static_cast<std::uint32_t>(rowsDone_);
    const auto rows = static_cast<std::uint32_t>(std::min(rowsPerStep, result_->height - rowsDone_));
    const auto half = static_cast<std::uint32_t>(result_->rays / 2);
    for (const VisibilityMean& mean : oracle_->pixelMeans(plan_, first, rows, half, firstSeed))
        result_->first.push_back(valueOf(mean));
    for (const VisibilityMean& mean : oracle_->pixelMeans(plan_, first, rows, half, secondSeed))
        result_->second.push_back(valueOf(mean));
    rowsDone_ += static_cast<int>(rows);
    if (rowsDone_ < result_->height) return false;
    store();
    oracle_.reset();
    return complete_ = true;
}

/// The cache keeps images: red is the first half, green the second.
bool ReferenceVisibilityBuilder::load() {
    const std::optional<LinearImage> image = cache_.load(key_, result_->width, result_->height);
    if (!image) return false;
    for (std::size_t i = 0; i < image->rgb.size(); i += 3) {
        result_->first.push_back(image->rgb[i]);
        result_->second.push_back(image->rgb[i + 1]);
    }
    rowsDone_ = result_->height;
    return true;
}

void ReferenceVisibilityBuilder::store() const {
    LinearImage image{result_->width, result_->height, {}};
    for (std::size_t i = 0; i < result_->first.size(); ++i)
        image.rgb.insert(image.rgb.end(), {result_->first[i], result_->second[i], 0.0f});
    cache_.store(key_, image);
}

std::shared_ptr<const ReferenceVisibility> referenceVisibility(const FramePlan& plan, int rays,
                                                               const ReferenceCache& cache,
                                                               const std::function<void(int, int)>& progress) {
    ReferenceVisibilityBuilder builder(plan, rays, cache);
    while (!builder.step())
        if (progress) progress(builder.rowsDone(), builder.rows());
    return builder.result();
}

}  // namespace timeshade
