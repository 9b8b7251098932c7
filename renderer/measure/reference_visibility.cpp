#include "measure/reference_visibility.h"

#include <algorithm>
#include <array>
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

/// Of both halves, and all pieces of the shutter alike.
int wholePackets(const FramePlan& plan, int rays) {
    const int all = 2 * oracle::RayPacket::size * std::max(1, static_cast<int>(plan.pieces.size()) / 2);
    return std::max(1, (rays + all - 1) / all) * all;
}

void digestLight(const LightPose& light, ReferenceDigest& digest) {
    digest.value(light.kind);
    digest.value(light.position);
    digest.value(light.axes);
    digest.value(light.outerConeAngle);
}

void digestPiece(const FramePlan& plan, ReferenceDigest& digest) {
    digest.values(plan.texels->positions);
    digest.value(plan.origin);
    digest.value(plan.camera.open);
    digest.value(plan.camera.close);
    digest.value(plan.camera.block.nearDistance);
    digestLight(plan.lightOpen, digest);
    digestLight(plan.lightClose, digest);
    digest.value(plan.light.block.farDistance);
}

void add(const VisibilityMean& part, VisibilityMean& whole) {
    whole.tested += part.tested;
    whole.lit += part.lit;
    whole.weights += part.weights;
    whole.litWeights += part.litWeights;
}

float valueOf(const VisibilityMean& mean) {
    return mean.exists() ? static_cast<float>(mean.value()) : ReferenceVisibility::NONE;
}

}  // namespace

std::string referenceVisibilityKey(const FramePlan& plan, int rays) {
    ReferenceDigest digest;
    digestPiece(plan, digest);
    for (const FramePlan& piece : plan.pieces) digestPiece(piece, digest);
    // Nothing is said of a box, so that its key is the one that it has always had.
    if (plan.block.response != SHUTTER_BOX) {
        digest.value(plan.block.response);
        digest.value(plan.block.responseWidth);
    }
    return fmt::format("converged visibility 2; frame {}; {} x {}; {} rays", digest.text(), plan.request.width,
                       plan.request.height, wholePackets(plan, rays));
}

ReferenceVisibilityBuilder::ReferenceVisibilityBuilder(FramePlan plan, int rays, const ReferenceCache& cache)
    : plan_(std::move(plan)),
      cache_(cache),
      key_(referenceVisibilityKey(plan_, rays)),
      result_(std::make_shared<ReferenceVisibility>()) {
    result_->width = plan_.request.width;
    result_->height = plan_.request.height;
    result_->rays = wholePackets(plan_, rays);
}

ReferenceVisibilityBuilder::~ReferenceVisibilityBuilder() = default;

bool ReferenceVisibilityBuilder::step() {
    if (complete_) return true;
    if (!soughtInCache_) {
        soughtInCache_ = true;
        return complete_ = load();
    }
    const int height = result_->height, width = result_->width, piece = rowsDone_ / height;
    const FramePlan& plan = pieceOf(plan_, piece, 1);
    if (!oracle_) oracle_ = std::make_unique<Oracle>(plan);
    const auto first = static_cast<std::uint32_t>(rowsDone_ % height);
    const auto rows = std::min<std::uint32_t>(rowsPerStep, static_cast<std::uint32_t>(height) - first);
    const auto rays = static_cast<std::uint32_t>(result_->rays / 2 / pieces());
    // Both before either counts: a pause may end the work.
    std::array<std::vector<VisibilityMean>, 2> means;
    for (std::size_t half = 0; half < 2; ++half) {
        const std::uint32_t seed = (half == 0 ? firstSeed : secondSeed) + 0x100u * static_cast<std::uint32_t>(piece);
        means[half] = oracle_->pixelMeans(plan, first, rows, rays, seed);
    }
    for (int half = 0; half < 2; ++half) {
        std::vector<VisibilityMean>& sums = sums_[static_cast<std::size_t>(half)];
        sums.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        std::size_t pixel = std::size_t{first} * static_cast<std::size_t>(width);
        for (const VisibilityMean& mean : means[static_cast<std::size_t>(half)]) add(mean, sums[pixel++]);
    }
    rowsDone_ += static_cast<int>(rows);
    if (rowsDone_ % height == 0) oracle_.reset();
    if (rowsDone_ < this->rows()) return false;
    for (const VisibilityMean& mean : sums_[0]) result_->first.push_back(valueOf(mean));
    for (const VisibilityMean& mean : sums_[1]) result_->second.push_back(valueOf(mean));
    store();
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
    rowsDone_ = rows();
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
