#include "measure/reference.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "gl/shader_source.h"
#include "measure/reference_digest.h"
#include "measure/reference_technique.h"
#include "plan/own_samples.h"
#include "shared/sample_pattern.shared.h"
#include "shared/shutter_response.shared.h"

namespace timeshade {

namespace {

std::string sceneDigest(const FramePlan& plan) {
    ReferenceDigest digest;
    digest.values(plan.texels->positions);
    digest.values(plan.texels->shading);
    for (const Material& material : *plan.materials) {
        digest.bytes(&material.baseColorFactor, sizeof material.baseColorFactor);
        digest.bytes(&material.metallicFactor, sizeof material.metallicFactor);
        digest.bytes(&material.roughnessFactor, sizeof material.roughnessFactor);
        digest.bytes(&material.emissiveFactor, sizeof material.emissiveFactor);
        for (const TextureUse& use : {material.baseColor, material.metallicRoughness, material.emissive}) {
            digest.bytes(&use.image, sizeof use.image);
            digest.bytes(&use.coordinates, sizeof use.coordinates);
            digest.bytes(&use.wrapU, sizeof use.wrapU);
            digest.bytes(&use.wrapV, sizeof use.wrapV);
        }
        const Cutout cutout = material.cutout.value_or(Cutout{});  // without one its threshold is 0
        digest.bytes(&cutout.threshold, sizeof cutout.threshold);
        digest.bytes(&cutout.nearest, sizeof cutout.nearest);
    }
    digest.values(plan.mesh->topology->moreCoordinates);
    digest.values(plan.mesh->topology->colours);
    for (const Image& image : *plan.images) digest.values(image.rgba);
    return digest.text();
}

/// Camera, light and shutter, without the samples of the image under test.
std::string viewDigest(const FramePlan& plan) {
    shared::FrameBlock block = plan.block;
    block.seed = block.strata = block.firstStratum = block.wholeStrata = block.positions = 0;
    block.mapWidth = block.pixelCentres = 0;
    block.timeScale = block.wholeTimeScale = 0.0f;
    block.lightCone.w = 0.0f;  // the width of a map texel
    ReferenceDigest digest;
    digest.bytes(&block, sizeof block);
    digest.bytes(&plan.camera.block, sizeof plan.camera.block);
    return digest.text();
}

/// Shading, sampling and receivers: a change in any of these files changes the picture.
std::string shaderDigest() {
    ReferenceDigest digest;
    for (const char* file : {"passes/shade.frag", "passes/stochastic.frag"}) {
        const std::string text = gl::readShader(file, {}).text;
        digest.bytes(text.data(), text.size());
    }
    return digest.text();
}

int batchesOf(const ReferenceOptions& options) {
    return std::max(1, (options.samplesPerPixel + maximumSamplesPerPixel - 1) / maximumSamplesPerPixel);
}

/// The same frame with the most strata that a frame takes, other random numbers, and its share of the weight.
FramePlan batchPlan(const FramePlan& plan, int batch) {
    FramePlan drawn = plan;
    drawn.request.samplesPerPixel = maximumSamplesPerPixel;
    drawn.request.samples = CameraSamples::Strata;
    drawn.block.positions = 0;
    drawn.block.strata = drawn.block.wholeStrata = maximumSamplesPerPixel;
    drawn.block.timeScale = drawn.block.wholeTimeScale = 1.0f / static_cast<float>(maximumSamplesPerPixel);
    // Seeds of their own, so that no image under test shares its noise with the reference.
    drawn.block.seed = 0x7ef00000u + static_cast<std::uint32_t>(batch);
    // What a pixel should show is the mean over its area, wherever the image under test has its samples.
    drawn.request.pixelCentres = false;
    drawn.block.pixelCentres = 0;
    keepNoSamples(drawn);
    shareSamples(drawn);
    return drawn;
}

/// Sum of the weights of each pixel's samples, in a picture's order: rows downwards.
std::vector<double> pixelWeights(const shared::FrameBlock& block) {
    std::vector<double> sums(std::size_t{block.imageSize.x} * block.imageSize.y);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const auto x = static_cast<std::uint32_t>(i % block.imageSize.x),
                   y = block.imageSize.y - 1 - static_cast<std::uint32_t>(i / block.imageSize.x);
        for (std::uint32_t k = 0; k < block.strata; ++k) {
            const float xi = shared::samplePattern({x, y}, k, block.seed, SALT_CAMERA).z;
            const float u = shared::sampleTime(block.timeBase, block.timeScale, k, xi);
            sums[i] += static_cast<double>(shared::shutterWeight(block.response, block.responseWidth, u));
        }
    }
    return sums;
}

}  // namespace

std::string referenceKey(const FramePlan& plan, const ReferenceOptions& options) {
    std::string key =
        fmt::format("reference 4; scene {}; frame {}; shaders {}; {} x {}; {} batches of {}; view {}",
                    sceneDigest(plan), viewDigest(plan), shaderDigest(), plan.request.width, plan.request.height,
                    batchesOf(options), maximumSamplesPerPixel, options.view == View::Final ? "final" : "visibility");
    for (const FramePlan& piece : plan.pieces)
        key += fmt::format("; piece {} {}", sceneDigest(piece), viewDigest(piece));
    return key;
}

ReferenceBuilder::ReferenceBuilder(FramePlan plan, const ReferenceOptions& options, const ReferenceCache& cache)
    : plan_(std::move(plan)),
      view_(options.view),
      cache_(cache),
      key_(referenceKey(plan_, options)),
      batches_(batchesOf(options)) {}

ReferenceBuilder::~ReferenceBuilder() = default;

bool ReferenceBuilder::step(FrameRenderer& renderer) {
    if (complete()) return true;
    if (!soughtInCache_) {
        soughtInCache_ = true;
        if (std::optional<LinearImage> cached = cache_.load(key_, plan_.request.width, plan_.request.height))
            image_ = std::move(*cached);
        return complete();
    }
    if (!truth_) truth_ = std::make_unique<ReferenceTechnique>();
    renderer.draw(batchPlan(plan_, done_), *truth_, view_);
    add(renderer.plan(), renderer.readRadiance());
    renderer.timer().finishFrame();  // a reference's times are nobody's measurement
    if (++done_ == batches_) finish();
    return complete();
}

void ReferenceBuilder::add(const FramePlan& drawn, const LinearImage& batch) {
    sum_.resize(batch.rgb.size());
    if (drawn.block.response == SHUTTER_BOX) {
        for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += static_cast<double>(batch.rgb[i]);
        return;
    }
    // One quotient over the samples of all batches: the mean of their quotients would keep the bias of each.
    const std::vector<double> weights = pixelWeights(drawn.block);
    weights_.resize(weights.size());
    for (std::size_t i = 0; i < weights.size(); ++i) weights_[i] += weights[i];
    for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += weights[i / 3] * static_cast<double>(batch.rgb[i]);
}

LinearImage ReferenceBuilder::soFar() const {
    if (complete()) return image_;
    LinearImage image{plan_.request.width, plan_.request.height, {}};
    image.rgb.reserve(sum_.size());
    for (std::size_t i = 0; i < sum_.size(); ++i)
        image.rgb.push_back(static_cast<float>(sum_[i] / (weights_.empty() ? done_ : weights_[i / 3])));
    return image;
}

void ReferenceBuilder::finish() {
    image_ = soFar();
    cache_.store(key_, image_);
    truth_.reset();  // and with it all that the ray tracer holds
}

LinearImage referenceImage(FrameRenderer& renderer, const FramePlan& plan, const ReferenceOptions& options,
                           ReferenceCache& cache) {
    ReferenceBuilder builder(plan, options, cache);
    int told = 0;
    while (!builder.step(renderer)) {
        if (options.progress && builder.batchesDone() > told)
            options.progress(told = builder.batchesDone(), builder.batches());
    }
    if (options.progress && builder.batchesDone() > told) options.progress(builder.batchesDone(), builder.batches());
    return builder.image();
}

}  // namespace timeshade
