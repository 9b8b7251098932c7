#include "techniques/tsm/tsm_shadow.h"

#include <fmt/format.h>

namespace timeshade {

const TechniqueDescription& TsmShadow::describe() {
    static const TechniqueDescription description{
        "tsm", "Time-dependent shadow maps (TSM)",
        "One stochastic map layer per stratum of the shutter: right in the mean for slow casters, noisy, and receivers "
        "that move towards the light shadow themselves.",
        "Akenine-Moller, Munkberg, Hasselgren 2007; dynamic bias: Andersson et al. 2015, eq. 12"};
    return description;
}

void TsmShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.number("bias", bias_, 0.5, 0.0, 64.0, "texels",
                   "How much nearer to the light a caster must be before it counts. Hides the self-shadow of receivers "
                   "that approach the light, and with it real contacts.");
    visitor.number("slope_bias", slopeBias_, 1.0, 0.0, 8.0, "half texels of slope",
                   "Further bias in proportion to how steeply the surface falls away from the light.");
    visitor.toggle("dynamic_bias", dynamicBias_, false,
                   "Moves each map depth along its own velocity to the receiver's time before the test (Andersson et al. "
                   "2015, eq. 12). Ends the self-shadow; costs one more map of velocities.");
}

SamplingTraits TsmShadow::samplingTraits() const {
    SamplingTraits traits;
    traits.times = SamplingTraits::Times::RandomInStratum;
    traits.texelCentres = true;
    traits.movesDepth = dynamicBias_;
    traits.biasTexels = static_cast<double>(bias_);
    return traits;
}

std::vector<PassDecision> TsmShadow::passes(const FramePlan& plan) const {
    const std::size_t drawn = plan.light.smallTriangles.size() + plan.light.largeTriangles.size();
    return {{"build",
             fmt::format("{} map layers, one a stratum, each texel at its own random time; {} triangles never reach the map",
                         plan.block.strata, plan.light.outsideTriangles),
             drawn},
            {"lookup", "each camera sample against the layer of its own stratum", 0}};
}

void TsmShadow::build(const TechniqueFrame& frame) {
    const int size = frame.plan.request.mapSize, layers = static_cast<int>(frame.plan.block.strata);
    const auto fits = [&](const std::optional<gl::Texture>& map) { return map && map->width() == size && map->layers() == layers; };
    if (!fits(depth_)) depth_ = gl::Texture::array2D("tsm depth", GL_DEPTH_COMPONENT32F, size, size, layers);
    if (!dynamicBias_)
        velocity_.reset();
    else if (!fits(velocity_))
        velocity_ = gl::Texture::array2D("tsm depth velocity", GL_R32F, size, size, layers);
    if (!rasterizer_) rasterizer_.emplace(programs_);
    using Output = StochasticRasterizer::Output;
    rasterizer_->draw(frame.mesh, frame.plan.light, StochasticRasterizer::Role::Light,
                      dynamicBias_ ? Output::DepthVelocity : Output::DepthOnly, frame.plan.block.strata,
                      velocity_ ? &*velocity_ : nullptr, *depth_);
}

void TsmShadow::lookup(const TechniqueFrame& frame) {
    gl::ShaderDefines defines = viewDefines(frame.plan);
    if (dynamicBias_) defines.emplace_back("DYNAMIC_BIAS", "1");
    const gl::Program& program = programs_.get({"tsm lookup", "passes/fullscreen.vert", "techniques/tsm/lookup.frag", defines});
    program.use();
    glUniform1f(2, bias_);
    glUniform1f(3, slopeBias_);
    depth_->bind(TECHNIQUE_UNIT);
    if (velocity_) velocity_->bind(TECHNIQUE_UNIT + 1);
    if (!lookupPass_) lookupPass_.emplace();
    lookupPass_->draw(frame, program);
}

std::vector<const gl::Texture*> TsmShadow::textures() const {
    std::vector<const gl::Texture*> all;
    for (const auto* texture : {&depth_, &velocity_})
        if (*texture) all.push_back(&**texture);
    return all;
}

std::size_t TsmShadow::bytes() const {
    return (depth_ ? depth_->bytes() : 0) + (velocity_ ? velocity_->bytes() : 0) + (rasterizer_ ? rasterizer_->bytes() : 0);
}

} // namespace timeshade
