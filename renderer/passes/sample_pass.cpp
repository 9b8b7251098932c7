#include "passes/sample_pass.h"

namespace timeshade {

namespace {
constexpr auto camera = StochasticRasterizer::Role::Camera;
constexpr auto numbers = StochasticRasterizer::Output::TriangleId;
} // namespace

void SamplePass::forget() {
    seen_ = drawn_ = 0;
    dropKept();
}

void SamplePass::dropKept() {
    kept_ = 0;
    keptIds_.reset();
    keptDepth_.reset();
    touched_.reset();
}

void SamplePass::draw(const FramePlan& plan, const GpuMesh& mesh, const SampleBuffer& samples) {
    const std::uint64_t version = plan.still.samples;
    const bool again = version != 0 && version == seen_, nothingMoves = plan.camera.moving.empty();
    seen_ = version;
    if (nothingMoves && again && drawn_ == version) return;
    drawn_ = nothingMoves ? version : 0;

    const int width = samples.ids().width(), height = samples.ids().height();
    if (!depth_ || depth_->width() != width || depth_->height() != height)
        depth_ = gl::Texture::array2D("sample depth", GL_DEPTH_COMPONENT32F, width, height, 1);
    if (again && !nothingMoves) return drawKept(plan, mesh, samples);
    dropKept();
    rasterizer_.draw(mesh, plan.camera, {&plan.camera.still, &plan.camera.moving}, camera, numbers, plan.block.strata, &samples.ids(), *depth_);
}

void SamplePass::drawKept(const FramePlan& plan, const GpuMesh& mesh, const SampleBuffer& samples) {
    const gl::Texture& ids = samples.ids();
    if (!keptIds_) {
        keptIds_ = gl::Texture::array2D("still sample ids", GL_R32UI, ids.width(), ids.height(), ids.layers());
        keptDepth_ = gl::Texture::array2D("still sample depth", GL_DEPTH_COMPONENT32F, ids.width(), ids.height(), ids.layers());
        touched_ = gl::Texture::image2D("touched pixels", GL_R8, ids.width(), ids.height());
    }
    if (kept_ != plan.still.samples)
        StochasticRasterizer(programs_).draw(mesh, plan.camera, {&plan.camera.still}, camera, numbers, plan.block.strata, &*keptIds_, *keptDepth_);
    kept_ = plan.still.samples;
    const StochasticRasterizer::Start start{*keptIds_, *keptDepth_, *touched_};
    rasterizer_.draw(mesh, plan.camera, {&plan.camera.moving}, camera, numbers, plan.block.strata, &ids, *depth_, &start);
}

const gl::Texture* SamplePass::stillIds(const FramePlan& plan, const SampleBuffer& samples) const {
    if (plan.still.samples == 0) return nullptr;
    if (plan.camera.moving.empty()) return &samples.ids();
    return kept_ == plan.still.samples && keptIds_ ? &*keptIds_ : nullptr;
}

std::size_t SamplePass::bytes() const {
    std::size_t sum = rasterizer_.bytes();
    for (const auto* texture : {&depth_, &keptIds_, &keptDepth_, &touched_}) sum += *texture ? (*texture)->bytes() : 0;
    return sum;
}

} // namespace timeshade
