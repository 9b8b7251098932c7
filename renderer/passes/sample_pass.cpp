#include "passes/sample_pass.h"

namespace timeshade {

namespace {
constexpr auto camera = StochasticRasterizer::Role::Camera;
constexpr auto numbers = StochasticRasterizer::Output::TriangleId;
}  // namespace

void SamplePass::forget() {
    seen_ = drawn_ = 0;
    dropCache();
}

void SamplePass::dropCache() {
    cached_ = 0;
    cachedIds_.reset();
    cachedDepth_.reset();
    dynamicPixels_.reset();
}

void SamplePass::draw(const FramePlan& plan, const GpuMesh& mesh, const SampleBuffer& samples) {
    const std::uint64_t version = plan.versions.samples;
    const bool again = version != 0 && version == seen_, nothingMoves = plan.camera.dynamicTriangles.empty();
    seen_ = version;
    if (nothingMoves && again && drawn_ == version) return;
    drawn_ = nothingMoves ? version : 0;

    const int width = samples.ids().width(), height = samples.ids().height();
    if (!depth_ || depth_->width() != width || depth_->height() != height)
        depth_ = gl::Texture::array2D("sample depth", GL_DEPTH_COMPONENT32F, width, height, 1);
    if (again && !nothingMoves) return drawOntoCached(plan, mesh, samples);
    dropCache();
    rasterizer_.draw(mesh, plan.camera, {&plan.camera.staticTriangles, &plan.camera.dynamicTriangles}, camera, numbers,
                     plan.block.strata, &samples.ids(), *depth_);
}

void SamplePass::drawOntoCached(const FramePlan& plan, const GpuMesh& mesh, const SampleBuffer& samples) {
    const gl::Texture& ids = samples.ids();
    if (!cachedIds_) {
        cachedIds_ = gl::Texture::array2D("still sample ids", GL_R32UI, ids.width(), ids.height(), ids.layers());
        cachedDepth_ =
            gl::Texture::array2D("still sample depth", GL_DEPTH_COMPONENT32F, ids.width(), ids.height(), ids.layers());
        dynamicPixels_ = gl::Texture::image2D("touched pixels", GL_R8, ids.width(), ids.height());
    }
    if (cached_ != plan.versions.samples)
        StochasticRasterizer(programs_).draw(mesh, plan.camera, {&plan.camera.staticTriangles}, camera, numbers,
                                             plan.block.strata, &*cachedIds_, *cachedDepth_);
    cached_ = plan.versions.samples;
    const StochasticRasterizer::Start start{*cachedIds_, *cachedDepth_, *dynamicPixels_};
    rasterizer_.draw(mesh, plan.camera, {&plan.camera.dynamicTriangles}, camera, numbers, plan.block.strata, &ids,
                     *depth_, &start);
}

const gl::Texture* SamplePass::staticIds(const FramePlan& plan, const SampleBuffer& samples) const {
    if (plan.versions.samples == 0) return nullptr;
    if (plan.camera.dynamicTriangles.empty()) return &samples.ids();
    return cached_ == plan.versions.samples && cachedIds_ ? &*cachedIds_ : nullptr;
}

std::size_t SamplePass::bytes() const {
    std::size_t sum = rasterizer_.bytes();
    for (const auto* texture : {&depth_, &cachedIds_, &cachedDepth_, &dynamicPixels_})
        sum += *texture ? (*texture)->bytes() : 0;
    return sum;
}

}  // namespace timeshade
