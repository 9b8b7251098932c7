#include "techniques/layers/layer_grids.h"

#include <fmt/format.h>

#include "core/error.h"
#include "gl/dispatch.h"

namespace timeshade {

namespace {

constexpr int mostLayers = 4;
constexpr int blockSide = 4;  // layers/samples.glsl: BLOCK

/// Over as many invocations as the texture has texels, in groups of 8 x 8.
void dispatchOver(const gl::Texture& texels) {
    gl::dispatch(gl::groupsFor(static_cast<std::size_t>(texels.width()), 8) *
                 gl::groupsFor(static_cast<std::size_t>(texels.height()), 8));
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

}  // namespace

gl::ShaderDefines LayerGrids::defines(const Options& options) {
    gl::ShaderDefines defines{{"TILE", fmt::format("{}", options.shape.tile)},
                              {"WINDOW", fmt::format("{}", options.shape.window)},
                              {"GRID", fmt::format("{}", options.shape.grid)}};
    if (options.asPublished) defines.emplace_back("AS_PUBLISHED", "1");
    return defines;
}

void LayerGrids::fit(const FramePlan& plan, const Options& options) {
    const MapSize size = plan.request.mapSize;
    const int tile = options.shape.tile;
    tiles_ = {(size.width + tile - 1) / tile, (size.height + tile - 1) / tile};
    const glm::ivec2 cells = tiles_ * options.shape.grid;
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (cells.x > most || cells.y > most)
        throw LimitError(
            fmt::format("the layers' grids need {} x {} texels, this device's GL_MAX_TEXTURE_SIZE is {}: "
                        "lower --map",
                        cells.x, cells.y, most));
    if (!motion_ || motion_->width() != tiles_.x || motion_->height() != tiles_.y) {
        motion_ = gl::Texture::array2D("layer motions", GL_RGBA32F, tiles_.x, tiles_.y, mostLayers);
        depth_ = gl::Texture::array2D("layer depths", GL_RGBA32F, tiles_.x, tiles_.y, mostLayers);
    }
    const glm::ivec2 blocks((size.width + blockSide - 1) / blockSide, (size.height + blockSide - 1) / blockSide);
    if (!ranges_ || ranges_->width() != blocks.x || ranges_->height() != blocks.y) {
        ranges_ = gl::Texture::array2D("depth ranges of blocks", GL_RG32F, blocks.x, blocks.y, 1);
    }
    if (!grids_ || grids_->width() != cells.x || grids_->height() != cells.y || grids_->layers() != options.layers) {
        grids_.reset();  // first, so that both need not fit at once
        grids_ = gl::Texture::array2D("layer grids", GL_RGBA32F, cells.x, cells.y, options.layers);
        grids_->setFilters(GL_LINEAR, GL_LINEAR);
        // Cells of layers that are not there are never read, but checks read all.
        glClearTexImage(grids_->name(), 0, GL_RGBA, GL_FLOAT, nullptr);
    }
}

void LayerGrids::build(const TechniqueFrame& frame, const Options& options, const Samples& samples) {
    fit(frame.plan, options);
    gl::ShaderDefines given = viewDefines(frame.plan);
    for (const auto& define : defines(options)) given.push_back(define);
    gl::Inputs inputs;
    inputs.texture("sampleDepth", samples.depth).texture("sampleMotion", samples.motion);
    inputs.set("strata", samples.strata.count);
    {
        const auto timed = frame.timer.scope("build/layers");
        gl::Inputs of = inputs;
        of.texture("extents", *ranges_).texture("emptySamples", samples.motion);
        of.set("sampleLength", samples.strata.length);
        programs_.get({.label = "blocks of samples", .defines = given, .compute = "techniques/layers/blocks.comp"})
            .use(of);
        dispatchOver(*ranges_);
        gl::Inputs own = inputs;
        own.texture("outputMotion", *motion_).texture("outputDepth", *depth_).texture("blockRanges", *ranges_);
        own.set("layersWanted", static_cast<std::uint32_t>(options.layers));
        own.set("leastRun", options.asPublished ? 1u : 2u);
        programs_.get({.label = "layers of tiles", .defines = given, .compute = "techniques/layers/cluster.comp"})
            .use(own);
        dispatchOver(*motion_);
    }
    const auto timed = frame.timer.scope("build/reprojection");
    if (options.filterAcross) given.emplace_back("V_FILTER", "1");
    inputs.texture("grids", *grids_);
    inputs.texture("layerMotion", *motion_).texture("layerDepth", *depth_);
    programs_.get({.label = "layer grids", .defines = given, .compute = "techniques/layers/deposit.comp"}).use(inputs);
    gl::dispatch(static_cast<std::size_t>(tiles_.x) * static_cast<std::size_t>(tiles_.y));
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void LayerGrids::addInputs(gl::Inputs& inputs) const {
    inputs.texture("grids", *grids_).texture("layerMotion", *motion_).texture("layerDepth", *depth_);
}

std::vector<const gl::Texture*> LayerGrids::textures() const {
    if (!grids_) return {};
    return {&*motion_, &*depth_, &*ranges_, &*grids_};
}

std::size_t LayerGrids::bytes() const {
    std::size_t sum = 0;
    for (const gl::Texture* texture : textures()) sum += texture->bytes();
    return sum;
}

}  // namespace timeshade
