#include "passes/light_maps.h"

#include <algorithm>
#include <string>

namespace timeshade {

void LightMaps::begin(const FramePlan& plan, const GpuMesh& mesh) {
    plan_ = &plan;
    mesh_ = &mesh;
    textures_.clear();
}

StaticMap& LightMaps::staticMap(Coverage coverage, bool keepsTriangles) {
    auto& entry = caches_.entry<StaticMap>(std::string(cacheNames) +
                                           (coverage == Coverage::Exact ? "static, exact" : "static, rasterized") +
                                           (keepsTriangles ? ", triangles" : ""));
    const CacheKey key = plan_->versions.casters;
    const bool held = entry.holds(key);
    StaticMap& map = entry.get(programs_, coverage, keepsTriangles);
    if (!held) map.draw(*plan_, *mesh_);
    entry.setKey(key);
    return map;
}

const gl::Texture& LightMaps::ofStaticCasters(Coverage coverage) { return handOut(staticMap(coverage).depth()); }

const StaticMap& LightMaps::ofStaticTriangles() {
    const StaticMap& map = staticMap(Coverage::Exact, true);
    handOut(map.depth());
    return map;
}

const gl::Texture& LightMaps::atInstant(float u) {
    const CacheKey key = plan_->versions.casters;
    auto& entry = caches_.entry<ShadowMap>(std::string(cacheNames) + "instant");
    const bool again = entry.wantedAgain(key);
    if (key != 0 && plan_->casters.nothingMoves()) {
        entry.drop();
        return ofStaticCasters(Coverage::Rasterized);
    }
    ShadowMap& map = entry.get(programs_);
    if (!again) {
        map.draw(*plan_, *mesh_, u);
        return handOut(map.depth());
    }
    std::vector<std::uint32_t> casters = plan_->casters.dynamicCasters;
    casters.insert(casters.end(), plan_->casters.nearPlane.begin(), plan_->casters.nearPlane.end());
    map.drawOnto(staticMap(Coverage::Rasterized).map(), *plan_, *mesh_, u, casters);
    return handOut(map.depth());
}

const gl::Texture& LightMaps::handOut(const gl::Texture& map) {
    if (std::find(textures_.begin(), textures_.end(), &map) == textures_.end()) textures_.push_back(&map);
    return map;
}

}  // namespace timeshade
