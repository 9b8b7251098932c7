#include "passes/sample_pass.h"

namespace timeshade {

namespace {

constexpr auto camera = StochasticRasterizer::Role::Camera;
constexpr auto numbers = StochasticRasterizer::Output::TriangleId;
const std::string staticName = "samples: static", drawnName = "samples: buffer";

}  // namespace

SamplePass::StaticSamples::StaticSamples(int width, int height, int strata)
    : ids(gl::Texture::array2D("static sample ids", GL_R32UI, width, height, strata)),
      depth(gl::Texture::array2D("static sample depth", GL_DEPTH_COMPONENT32F, width, height, strata)),
      dynamicPixels(gl::Texture::image2D("dynamic pixels", GL_R8, width, height)) {}

void SamplePass::draw(const FramePlan& plan, const GpuMesh& mesh, SampleBuffer& samples) {
    const CacheKey key = plan.versions.samples;
    const bool nothingMoves = plan.camera.dynamicTriangles.empty();
    samples.setDynamicPixels(nullptr);
    auto& drawn = caches_.entry<NoContent>(drawnName);
    const bool again = drawn.wantedAgain(key);
    if (nothingMoves && again && drawn.holds(key)) return;
    drawn.setKey(nothingMoves ? key : 0);

    const int width = samples.ids().width(), height = samples.ids().height();
    if (!depth_ || depth_->width() != width || depth_->height() != height)
        depth_ = gl::Texture::array2D("sample depth", GL_DEPTH_COMPONENT32F, width, height, 1);
    if (again && !nothingMoves) return drawOntoStatic(plan, mesh, samples);
    caches_.entry<StaticSamples>(staticName).drop();
    rasterizer_.draw(mesh, plan.camera, {&plan.camera.staticTriangles, &plan.camera.dynamicTriangles}, camera, numbers,
                     StochasticRasterizer::Strata::ofSamples(plan), &samples.ids(), *depth_);
}

void SamplePass::drawOntoStatic(const FramePlan& plan, const GpuMesh& mesh, SampleBuffer& samples) {
    const gl::Texture& ids = samples.ids();
    const CacheKey key = plan.versions.samples;
    auto& entry = caches_.entry<StaticSamples>(staticName);
    const bool held = entry.holds(key);
    StaticSamples& cached = entry.get(ids.width(), ids.height(), ids.layers());
    if (!held)
        StochasticRasterizer(programs_).draw(mesh, plan.camera, {&plan.camera.staticTriangles}, camera, numbers,
                                             StochasticRasterizer::Strata::ofSamples(plan), &cached.ids, cached.depth);
    entry.setKey(key);
    const StochasticRasterizer::Start start{cached.ids, cached.depth, cached.dynamicPixels};
    rasterizer_.draw(mesh, plan.camera, {&plan.camera.dynamicTriangles}, camera, numbers,
                     StochasticRasterizer::Strata::ofSamples(plan), &ids, *depth_, &start);
    samples.setDynamicPixels(&cached.dynamicPixels);
}

const gl::Texture* SamplePass::staticIds(const FramePlan& plan, const SampleBuffer& samples) const {
    const CacheKey key = plan.versions.samples;
    if (key == 0) return nullptr;
    if (plan.camera.dynamicTriangles.empty()) return &samples.ids();
    auto& entry = caches_.entry<StaticSamples>(staticName);
    return entry.holds(key) ? &entry.find()->ids : nullptr;
}

}  // namespace timeshade
