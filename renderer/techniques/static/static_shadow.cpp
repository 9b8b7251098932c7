#include "techniques/static/static_shadow.h"

#include <fmt/format.h>

#include "technique/fitted_map_prediction.h"
#include "technique/technique_entry.h"

namespace timeshade {

const TechniqueDescription& StaticShadow::describe() {
    static const TechniqueDescription description{
        .name = "static",
        .title = "Static shadow map",
        .shortTitle = "Static map",
        .summary = "One ordinary shadow map at the centre of the shutter: the cheapest, and blind to motion.",
        .source = "Williams 1978; PCF: Reeves, Salesin, Cook 1987",
        .wrong = "All motion: whatever moves throws the sharp shadow of one instant, the centre of the shutter.",
        .look = "octopus: the arms are blurred, their shadows are not.",
        .picture = "Shadows of arms: left static, right ground truth.",
        .references = {"L. Williams 1978: Casting curved shadows on curved surfaces. SIGGRAPH.",
                       "W. Reeves, D. Salesin, R. Cook 1987: Rendering antialiased shadows with depth maps. SIGGRAPH."},
    };
    return description;
}

void StaticShadow::visitSettings(SettingsVisitor& visitor) {
    map_.visitSettings(visitor);
    visitor.choice(
        "fit", fit_, 0, {"whole-light", "camera-view", "lispsm"},
        "What the map covers: all that the light reaches; what the camera sees of it; or that, with more "
        "texels for what is near (light space perspective shadow maps). Fitted, it is drawn in every frame.");
}

std::shared_ptr<const Prediction> StaticShadow::prediction() const {
    return fit() != MapFit::Light ? std::make_shared<FittedMapPrediction>() : Technique::prediction();
}

std::vector<std::string> StaticShadow::warnings(const FramePlan& plan) const {
    const std::string shortfall = fit() == MapFit::Light ? "" : fitMap(plan, fit(), {}).shortfall;
    if (shortfall.empty()) return {};
    return {fmt::format("{}: {}", fit() == MapFit::Warped ? "fit lispsm" : "fit camera-view", shortfall)};
}

void StaticShadow::build(const TechniqueFrame& frame) {
    if (fit() == MapFit::Light) {
        fitted_.reset();
        return map_.build(frame);
    }
    if (!fitted_) fitted_.emplace(programs_);
    mapFromPlane_ = fitMap(frame.plan, fit(), {}).mapFromPlane;
    fitted_->draw(frame.plan, frame.mesh, OrdinaryMap::instantOf(frame.plan), glm::mat3(mapFromPlane_));
}

LookupProgram StaticShadow::lookupProgram(const TechniqueFrame& frame, Casters casters) {
    if (fit() == MapFit::Light) return map_.lookupProgram(frame, casters);
    LookupProgram lookup{"fitted shadow map lookup", "techniques/static/fitted_lookup.frag", {}, {}};
    lookup.defines.emplace_back("PCF_RADIUS", fmt::format("{}", map_.pcfRadius()));
    lookup.inputs.set("instant", OrdinaryMap::instantOf(frame.plan))
        .set("mapFromPlane", glm::mat3(mapFromPlane_))
        .set("planeFromMap", glm::mat3(glm::inverse(mapFromPlane_)))
        .texture("shadowMap", fitted_->depth());
    return lookup;
}

StoredAlongLine StaticShadow::storedAlong(const TechniqueFrame& frame, const MapLine& line) {
    if (fit() != MapFit::Light) return {{}, "the fitted map has other texels than the shadow map: not shown"};
    StoredAlongLine stored = map_.storedAlong(frame, line, 0.0, 1.0);
    stored.note = "one map, of u = 0.5, for the whole shutter";
    return stored;
}

std::vector<const gl::Texture*> StaticShadow::textures() const {
    return fitted_ ? std::vector<const gl::Texture*>{&fitted_->depth()} : std::vector<const gl::Texture*>{};
}

std::vector<PassDecision> StaticShadow::passes(const FramePlan& plan) const {
    static constexpr const char* covers[] = {"", ", fitted to what the camera sees",
                                             ", fitted to what the camera sees, with a perspective warp"};
    return {{"build", fmt::format("one ordinary shadow map at u = 0.5{}; motion is ignored on purpose", covers[fit_]),
             plan.motion.triangles},
            {"lookup", "each camera sample's surface point, taken to u = 0.5, against that map", 0}};
}

TechniqueEntry staticTechnique() { return entryOf<StaticShadow>(); }

}  // namespace timeshade
