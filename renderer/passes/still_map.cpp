#include "passes/still_map.h"

namespace timeshade {

void StillMap::draw(const FramePlan& plan, const GpuMesh& mesh) {
    if (drawn() && plan.still.casters != 0 && plan.still.casters == version_) return;
    version_ = plan.still.casters;
    if (coverage_ == Coverage::Rasterized) {
        map_.draw(plan, mesh, 0.0f, plan.casters.still);
        return;
    }
    const int size = plan.request.mapSize;
    if (!exact_ || exact_->width() != size) exact_ = gl::Texture::array2D("still map", GL_DEPTH_COMPONENT32F, size, size, 1);
    StochasticRasterizer(programs_).draw(mesh, plan.light, {&plan.light.still}, StochasticRasterizer::Role::Light,
                                         StochasticRasterizer::Output::DepthOnly, 1, nullptr, *exact_);
}

} // namespace timeshade
