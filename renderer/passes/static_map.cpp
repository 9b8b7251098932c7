#include "passes/static_map.h"

namespace timeshade {

void StaticMap::draw(const FramePlan& plan, const GpuMesh& mesh) {
    if (coverage_ == Coverage::Rasterized) {
        map_.draw(plan, mesh, 0.0f, plan.casters.staticCasters);
        return;
    }
    const int size = plan.request.mapSize;
    if (!exact_ || exact_->width() != size)
        exact_ = gl::Texture::array2D("static map", GL_DEPTH_COMPONENT32F, size, size, 1);
    StochasticRasterizer(programs_).draw(mesh, plan.light, {&plan.light.staticTriangles},
                                         StochasticRasterizer::Role::Light, StochasticRasterizer::Output::DepthOnly, 1,
                                         nullptr, *exact_);
}

}  // namespace timeshade
