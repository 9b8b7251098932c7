#include "technique/ordinary_map_shadow.h"

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

Footprint OrdinaryMapShadow::footprint() const {
    Footprint footprint;
    footprint.filterTexels = pcfRadius_ > 0 ? 2.0 * pcfRadius_ + 1.0 : 0.0;
    return footprint;
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
    const FramePlan& plan = frame.plan;
    const std::uint64_t version = plan.versions.casters;
    const bool again = version != 0 && version == seen_;
    seen_ = version;
    staticAlone_ = version != 0 && plan.casters.nothingMoves();
    if (again || staticAlone_) {
        if (!still_) still_.emplace(programs_);
        still_->draw(plan, frame.mesh);
    } else {
        still_.reset();
    }
    if (staticAlone_) {
        map_.reset();
        return;
    }
    if (!map_) map_.emplace(programs_);
    if (!still_) {
        map_->draw(plan, frame.mesh, instantOf(plan));
        return;
    }
    std::vector<std::uint32_t> moving = plan.casters.dynamicCasters;
    moving.insert(moving.end(), plan.casters.nearPlane.begin(), plan.casters.nearPlane.end());
    map_->drawOnto(still_->map(), plan, frame.mesh, instantOf(plan), moving);
}

void OrdinaryMapShadow::lookup(const TechniqueFrame& frame) {
    frame.lookup.draw(frame, [&](gl::ShaderDefines defines) -> const gl::Program& {
        const bool staticAlone = staticAlone_ || (!defines.empty() && defines.front().first == "STATIC_CASTERS_ONLY");
        if (staticAlone && !still_) {  // another technique of this kind drew the frame before
            still_.emplace(programs_);
            still_->draw(frame.plan, frame.mesh);
        }
        for (const auto& define : viewDefines(frame.plan)) defines.push_back(define);
        defines.emplace_back("PCF_RADIUS", fmt::format("{}", pcfRadius_));
        const gl::Program& program =
            programs_.get({"shadow map lookup", "passes/fullscreen.vert", "passes/shadow_map_lookup.frag", defines});
        program.use();
        glUniform1f(1, instantOf(frame.plan));
        glUniform1f(2, bias_);
        glUniform1f(3, slopeBias_);
        (staticAlone ? still_->depth() : map_->depth()).bind(TECHNIQUE_UNIT);
        return program;
    });
}

std::vector<const gl::Texture*> OrdinaryMapShadow::textures() const {
    std::vector<const gl::Texture*> all;
    if (map_) all.push_back(&map_->depth());
    if (still_) all.push_back(&still_->depth());
    return all;
}

}  // namespace timeshade
