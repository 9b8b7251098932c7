#include "techniques/ordinary_map_shadow.h"

#include <fmt/format.h>

namespace timeshade {

void OrdinaryMapShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.number("bias", bias_, 0.5, 0.0, 16.0, "texels",
                   "How much nearer to the light a caster must be before it counts. Too little: speckles on lit "
                   "surfaces. Too much: shadows come loose at contacts.");
    visitor.number("slope_bias", slopeBias_, 1.0, 0.0, 8.0, "half texels of slope",
                   "Further bias in proportion to how steeply the surface falls away from the light.");
    visitor.whole("pcf_radius", pcfRadius_, 0, 0, 3, "texels",
                  "Percentage-closer filtering over (2n + 1) x (2n + 1) texels; 0 switches it off. Softens the map's "
                  "steps, costs that many tests.");
}

SamplingTraits OrdinaryMapShadow::samplingTraits(SamplingTraits::Times times, int instants) const {
    SamplingTraits traits;
    traits.times = times;
    traits.instants = instants;
    traits.texelCentres = true;
    traits.biasTexels = static_cast<double>(bias_);
    return traits;
}

float OrdinaryMapShadow::instantOf(const FramePlan& plan) {
    return plan.block.timeBase + 0.5f * static_cast<float>(plan.block.strata) * plan.block.timeScale;
}

void OrdinaryMapShadow::build(const TechniqueFrame& frame) {
    if (!map_) map_.emplace(programs_);
    map_->draw(frame.plan, frame.mesh, instantOf(frame.plan));
}

void OrdinaryMapShadow::lookup(const TechniqueFrame& frame) {
    gl::ShaderDefines defines = viewDefines(frame.plan);
    defines.emplace_back("PCF_RADIUS", fmt::format("{}", pcfRadius_));
    const gl::Program& program =
        programs_.get({"shadow map lookup", "passes/fullscreen.vert", "passes/shadow_map_lookup.frag", defines});
    program.use();
    glUniform1f(1, instantOf(frame.plan));
    glUniform1f(2, bias_);
    glUniform1f(3, slopeBias_);
    map_->depth().bind(TECHNIQUE_UNIT);
    if (!lookupPass_) lookupPass_.emplace();
    lookupPass_->draw(frame, program);
}

std::vector<const gl::Texture*> OrdinaryMapShadow::textures() const {
    if (!map_) return {};
    return {&map_->depth()};
}

} // namespace timeshade
