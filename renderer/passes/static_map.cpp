#include "passes/static_map.h"

namespace timeshade {

void StaticMap::draw(const FramePlan& plan, const GpuMesh& mesh) {
    if (coverage_ == Coverage::Rasterized) {
        map_.draw(plan, mesh, 0.0f, plan.casters.staticCasters);
        return;
    }
    const MapSize size = plan.request.mapSize;
    if (!exact_ || MapSize(exact_->width(), exact_->height()) != size) {
        exact_ = gl::Texture::array2D("static map", GL_DEPTH_COMPONENT32F, size.width, size.height, 1);
        if (keepsTriangles_)
            triangles_ = gl::Texture::array2D("triangles of the static map", GL_R32UI, size.width, size.height, 1);
    }
    using Output = StochasticRasterizer::Output;
    StochasticRasterizer(programs_).draw(mesh, plan.light, {&plan.light.staticTriangles},
                                         StochasticRasterizer::Role::Light,
                                         keepsTriangles_ ? Output::TriangleId : Output::DepthOnly,
                                         {1, plan.block.timeScale}, triangles_ ? &*triangles_ : nullptr, *exact_);
}

}  // namespace timeshade
