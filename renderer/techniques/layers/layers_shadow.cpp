#include "techniques/layers/layers_shadow.h"

#include <array>
#include <map>

#include <fmt/format.h>

#include "technique/technique_entry.h"
#include "techniques/layers/layers_prediction.h"

namespace timeshade {

namespace {

/// Section 5; section 6 for the quality comparisons.
constexpr LayerGrids::Shape shapes[] = {{8, 16, 16}, {4, 12, 8}};

}  // namespace

const TechniqueDescription& LayersShadow::describe() {
    static const TechniqueDescription description{
        .name = "layers",
        .title = "Filtered layered shadow maps",
        .shortTitle = "Layers",
        .summary =
            "A time-dependent map whose samples are sorted into layers of like depth and moved along each layer's "
            "mean motion, so that a lookup may filter them: less noise, blurred detail, much memory.",
        .source = "Andersson, Hasselgren, Munkberg, Akenine-Moller 2015",
        .wrong =
            "What a mean cannot hold: opposite motions in one layer, more than four layers, paths that are not "
            "straight. Light bleeds where a layer is deep. Edges are hard to find where the light moves.",
        .look = "octopus beside tsm with the same samples; then layers as_published, and one layer instead of four.",
        .picture = "octopus: left TSM, right layers of the same samples.",
        .references = {"M. Andersson, J. Hasselgren, J. Munkberg, T. Akenine-Moller 2015: Filtered stochastic shadow "
                       "mapping using a layered approach. Computer Graphics Forum."},
    };
    return description;
}

void LayersShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.number("bias", bias_, 1.0, 0.0, 64.0, "texels",
                   "How much nearer to the light than the receiver the layers must be before they count.");
    visitor.number("slope_bias", slopeBias_, 0.5, 0.0, 8.0, "half texels of slope",
                   "Further bias in proportion to how steeply the surface falls away from the light. Not as "
                   "published.");
    visitor.whole("strata", strata_, 0, 0, maximumSamplesPerPixel, "layers",
                  "Samples of the map per texel, one a stratum of the shutter; 0: as many as a pixel has camera "
                  "samples.");
    visitor.choice("tiles", tiles_, 0, {"8x8", "4x4"},
                   "Size of a tile in texels. 8x8: window of 16, grid of 16 x 16. 4x4: window of 12, grid of 8 x 8; "
                   "finer, twice the work.");
    visitor.whole("count", layers_, 4, 1, 4, "layers", "Largest number of layers a tile is cut into.");
    visitor.whole("shown_layer", shownLayer_, 1, 1, 4, "layer", "Which layer views show, counted from the light.");
    visitor.toggle("neighbour_tiles", neighbourTiles_, true,
                   "Near a tile's border the neighbouring tile may answer, by chance: hides borders.");
    visitor.toggle("v_filter", filterAcross_, true,
                   "Blurs a layer across its motion where that is large: hides streaks.");
    visitor.toggle("as_published", asPublished_, false,
                   "As the paper states it: every triangle in the layers, straight paths in the map, moments about 0, "
                   "one variance test of filtered moments.");
    visitor.toggle("equation_9_alone", equation9Alone_, false,
                   "As published only: equation 9 as it stands in the paper, also where the receiver is nearer than "
                   "the mean, where the test that it cites (Donnelly, Lauritzen 2006) says lit.");
}

Footprint LayersShadow::footprint() const {
    return {.time = Footprint::Time::Stratum, .space = Footprint::Space::Point, .filterTexels = 2.0};
}

SamplingTraits LayersShadow::samplingTraits() const {
    return {.times = SamplingTraits::Times::RandomInStratum,
            .strata = strata_,
            .texelCentres = true,
            .biasTexels = static_cast<double>(bias_)};
}

std::shared_ptr<const Prediction> LayersShadow::prediction() const {
    return std::make_shared<LayersPrediction>(
        LayersPrediction::Options{optionsOf(), equation9Alone_, neighbourTiles_, strata_, static_cast<double>(bias_)});
}

LayerGrids::Options LayersShadow::optionsOf() const { return {shapes[tiles_], asPublished_, filterAcross_, layers_}; }

bool LayersShadow::hasCasters(const FramePlan& plan) const {
    return !plan.light.dynamicTriangles.empty() || (asPublished_ && !plan.light.staticTriangles.empty());
}

std::vector<PassDecision> LayersShadow::passes(const FramePlan& plan) const {
    std::vector<PassDecision> passes;
    if (!asPublished_)
        passes.push_back({"build/static map",
                          "one map of what stands still in the light's frame, kept until something of it changes",
                          plan.light.staticTriangles.count()});
    if (hasCasters(plan)) {
        const std::size_t triangles =
            plan.light.dynamicTriangles.count() + (asPublished_ ? plan.light.staticTriangles.count() : 0);
        const auto [tile, window, grid] = shapes[tiles_];
        passes.push_back({"build/samples",
                          fmt::format("{} map layers, one a stratum, each texel at its own random time, with the "
                                      "motion of what it sees",
                                      strataOf(plan).count),
                          triangles});
        passes.push_back({"build/layers",
                          fmt::format("up to {} layers of depth for each tile of {} x {} texels, of the samples in a "
                                      "window of {} x {}",
                                      layers_, tile, tile, window, window),
                          0});
        passes.push_back({"build/reprojection",
                          fmt::format("those samples at the middle of the shutter, in {} x {} cells", grid, grid), 0});
    }
    passes.push_back({"lookup",
                      hasCasters(plan) ? "each camera sample against the filtered layers of its tile"
                                       : "nothing moves in the light's frame: each camera sample against the one map",
                      0});
    return passes;
}

void LayersShadow::build(const TechniqueFrame& frame) {
    staticMap_ = nullptr;
    if (!asPublished_) {
        const auto timed = frame.timer.scope("build/static map");
        staticMap_ = &frame.maps.ofStaticCasters(LightMaps::Coverage::Exact);
    }
    if (!hasCasters(frame.plan)) {
        depth_.reset();
        motion_.reset();
        rasterizer_.reset();
        grids_.reset();
        return;
    }
    const MapSize size = frame.plan.request.mapSize;
    const StochasticRasterizer::Strata strata = strataOf(frame.plan);
    {
        const auto timed = frame.timer.scope("build/samples");
        if (!depth_ || MapSize(depth_->width(), depth_->height()) != size ||
            depth_->layers() != static_cast<int>(strata.count)) {
            const auto count = static_cast<int>(strata.count);
            depth_ = gl::Texture::array2D("layers' samples", GL_DEPTH_COMPONENT32F, size.width, size.height, count);
            motion_ = gl::Texture::array2D("layers' motions", GL_RGBA32F, size.width, size.height, count);
        }
        if (!rasterizer_) rasterizer_.emplace(programs_);
        const TriangleLists none;
        rasterizer_->draw(
            frame.mesh, frame.plan.light,
            {&frame.plan.light.dynamicTriangles, asPublished_ ? &frame.plan.light.staticTriangles : &none},
            StochasticRasterizer::Role::Light, StochasticRasterizer::Output::Motion, strata, &*motion_, *depth_);
    }
    if (!grids_) grids_.emplace(programs_);
    grids_->build(frame, optionsOf(), {*depth_, *motion_, strata});
}

LookupProgram LayersShadow::lookupProgram(const TechniqueFrame& frame, Casters) {
    LookupProgram lookup{"layers lookup", "techniques/layers/lookup.frag", LayerGrids::defines(optionsOf()), {}};
    lookup.defines.emplace_back("PCF_RADIUS", "1");
    if (asPublished_ && equation9Alone_) lookup.defines.emplace_back("EQUATION_9_ALONE", "1");
    if (neighbourTiles_) lookup.defines.emplace_back("NEIGHBOUR_TILES", "1");
    if (staticMap_ != nullptr) lookup.inputs.texture("staticMap", *staticMap_);
    if (grids_) {
        lookup.defines.emplace_back("DYNAMIC_CASTERS", "1");
        lookup.inputs.texture("sampleDepth", *depth_).texture("sampleMotion", *motion_);
        const StochasticRasterizer::Strata strata = strataOf(frame.plan);
        lookup.inputs.set("layers", strata.count).set("layerLength", strata.length);
        if (strata_ > 0) lookup.defines.emplace_back("OWN_STRATA", "1");
        grids_->addInputs(lookup.inputs);
    }
    return lookup;
}

std::vector<TechniqueView> LayersShadow::views() const {
    return {{"layers", "Layers of each tile, as the light sees them", "layers", 0.0, 4.0, false},
            {"opacity", "Opacity of the layer shown", "", 0.0, 1.0, false},
            {"weight", "Samples that a cell of the layer shown is made of", "samples", 0.0, 16.0, false},
            {"motion", "Mean motion of the layer shown", "texels", 0.0, 64.0, false},
            {"direction", "Direction of the layer shown", "turns", 0.0, 1.0, false}};
}

void LayersShadow::drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) {
    static const std::map<std::string, std::string> variants{{"layers", "VIEW_COUNT"},
                                                             {"opacity", "VIEW_OPACITY"},
                                                             {"weight", "VIEW_WEIGHT"},
                                                             {"motion", "VIEW_WAY"},
                                                             {"direction", "VIEW_DIRECTION"}};
    const auto variant = variants.find(name);
    if (variant == variants.end()) return Technique::drawView(frame, name, values);
    const gl::Framebuffer& target = viewTarget_.bind(values);
    if (!grids_) {
        const std::array<GLfloat, 4> nothing{-1.0f};
        glClearNamedFramebufferfv(target.name(), GL_COLOR, 0, nothing.data());
        return;
    }
    gl::ShaderDefines defines = frame.defines();
    for (const auto& define : LayerGrids::defines(optionsOf())) defines.push_back(define);
    defines.emplace_back(variant->second, "1");
    const gl::Program& program =
        programs_.get({"layers view", "passes/fullscreen.vert", "techniques/layers/view.frag", defines});
    gl::Inputs inputs;
    grids_->addInputs(inputs);
    program.use(inputs);
    frame.fullscreen.draw(program);
}

StoredAlongLine LayersShadow::storedAlong(const TechniqueFrame& frame, const MapLine& line) {
    StoredAlongLine stored;
    if (staticMap_ != nullptr) addMapMarks(frame.plan, *staticMap_, line, 0.0, 1.0, stored.marks);
    if (grids_ && hasCasters(frame.plan)) grids_->addMarks(frame.plan, optionsOf(), line, stored.marks);
    stored.note = "each layer's cells along the layer's motion, at their mean depth, as opaque as their samples say";
    return stored;
}

std::vector<const gl::Texture*> LayersShadow::textures() const {
    std::vector<const gl::Texture*> all;
    if (!grids_) return all;
    all = grids_->textures();
    all.push_back(&*depth_);
    all.push_back(&*motion_);
    return all;
}

std::size_t LayersShadow::bytes() const {
    std::size_t sum = (grids_ ? grids_->bytes() : 0) + (rasterizer_ ? rasterizer_->bytes() : 0);
    for (const auto* texture : {&depth_, &motion_}) sum += *texture ? (*texture)->bytes() : 0;
    return sum;
}

TechniqueEntry layersTechnique() { return entryOf<LayersShadow>(); }

}  // namespace timeshade
