#include "measure/reference.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "gl/shader_source.h"
#include "measure/reference_digest.h"
#include "measure/reference_technique.h"

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
        digest.bytes(&material.baseColorImage, sizeof material.baseColorImage);
        digest.bytes(&material.metallicRoughnessImage, sizeof material.metallicRoughnessImage);
    }
    for (const Image& image : *plan.images) digest.values(image.rgba);
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
    drawn.block.strata = maximumSamplesPerPixel;
    drawn.block.timeScale = 1.0f / static_cast<float>(maximumSamplesPerPixel);
    // Seeds of their own, so that no image under test shares its noise with the reference.
    drawn.block.seed = 0x7ef00000u + static_cast<std::uint32_t>(batch);
    // What a pixel should show is the mean over its area, wherever the image under test has its samples.
    drawn.request.pixelCentres = false;
    drawn.block.pixelCentres = 0;
    return drawn;
}

}  // namespace

std::string referenceKey(const FramePlan& plan, const ReferenceOptions& options) {
    shared::FrameBlock block = plan.block;
    block.seed = block.strata = 0;  // of the image under test
    block.mapWidth = block.pixelCentres = 0;
    block.timeScale = 0.0f;
    block.lightCone.w = 0.0f;  // the width of a map texel
    ReferenceDigest frame;
    frame.bytes(&block, sizeof block);
    frame.bytes(&plan.camera.block, sizeof plan.camera.block);
    return fmt::format("reference 2; scene {}; frame {}; shaders {}; {} x {}; {} batches of {}; view {}",
                       sceneDigest(plan), frame.text(), shaderDigest(), plan.request.width, plan.request.height,
                       batchesOf(options), maximumSamplesPerPixel,
                       options.view == View::Final ? "final" : "visibility");
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
    const LinearImage batch = renderer.readRadiance();
    renderer.timer().finishFrame();  // a reference's times are nobody's measurement
    sum_.resize(batch.rgb.size());
    for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += static_cast<double>(batch.rgb[i]);
    if (++done_ == batches_) finish();
    return complete();
}

void ReferenceBuilder::finish() {
    image_ = {plan_.request.width, plan_.request.height, {}};
    for (const double value : sum_) image_.rgb.push_back(static_cast<float>(value / batches_));
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
