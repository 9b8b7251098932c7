#include "technique/ordinary_map.h"

#include <fmt/format.h>

namespace timeshade {

void OrdinaryMap::visitSettings(SettingsVisitor& visitor) {
    visitor.number("bias", bias_, 0.5, 0.0, 16.0, "texels",
                   "How much nearer to the light a caster must be before it counts. Too little: speckles on lit "
                   "surfaces. Too much: shadows come loose at contacts.");
    visitor.number("slope_bias", slopeBias_, 1.0, 0.0, 8.0, "half texels of slope",
                   "Further bias in proportion to how steeply the surface falls away from the light.");
    visitor.whole("pcf_radius", pcfRadius_, 0, 0, 3, "texels",
                  "Percentage-closer filtering over (2n + 1) x (2n + 1) texels; 0 switches it off. Softens the map's "
                  "steps, costs that many tests.");
}

Footprint OrdinaryMap::footprint() const {
    Footprint footprint;
    footprint.filterTexels = Footprint::filterOf(pcfRadius_);
    return footprint;
}

SamplingTraits OrdinaryMap::samplingTraits() const {
    return {.times = SamplingTraits::Times::OneInstant, .texelCentres = true, .biasTexels = static_cast<double>(bias_)};
}

float OrdinaryMap::instantOf(const FramePlan& plan) {
    return plan.block.timeBase + 0.5f * static_cast<float>(plan.block.strata) * plan.block.timeScale;
}

StoredAlongLine OrdinaryMap::storedAlong(const TechniqueFrame& frame, const MapLine& line, double uFrom,
                                         double uTo) const {
    StoredAlongLine stored;
    addMapMarks(frame.plan, *map_, line, uFrom, uTo, stored.marks);
    return stored;
}

LookupProgram OrdinaryMap::lookupProgram(const TechniqueFrame& frame, Casters casters) const {
    const gl::Texture& map =
        casters == Casters::Static ? frame.maps.ofStaticCasters(LightMaps::Coverage::Rasterized) : *map_;
    LookupProgram lookup{"shadow map lookup", "passes/shadow_map_lookup.frag", {}, {}};
    lookup.defines.emplace_back("PCF_RADIUS", fmt::format("{}", pcfRadius_));
    lookup.inputs.set("instant", instantOf(frame.plan)).texture("shadowMap", map);
    return lookup;
}

}  // namespace timeshade
