#include "passes/sample_pass.h"

namespace timeshade {

void SamplePass::draw(const FramePlan& plan, const GpuMesh& mesh, const SampleBuffer& samples) {
    const int width = samples.ids().width(), height = samples.ids().height();
    if (!depth_ || depth_->width() != width || depth_->height() != height)
        depth_ = gl::Texture::array2D("sample depth", GL_DEPTH_COMPONENT32F, width, height, 1);
    rasterizer_.draw(mesh, plan.camera, StochasticRasterizer::Role::Camera, StochasticRasterizer::Output::TriangleId,
                     plan.block.strata, &samples.ids(), *depth_);
}

} // namespace timeshade
