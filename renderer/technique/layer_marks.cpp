#include "technique/layer_marks.h"

#include <cmath>

namespace timeshade {

void addLayerMarks(const FramePlan& plan, const gl::Texture& map, const MapLine& line,
                   const std::function<float(glm::uvec2 texel, std::uint32_t layer)>& timeOf,
                   std::vector<StoredMark>& marks) {
    const std::vector<TexelOnLine> texels = texelsAlong(line, {map.width(), map.height()});
    for (int layer = 0; layer < map.layers(); ++layer) {
        const std::vector<float> depths = valuesAlong(map, layer, texels);
        for (std::size_t i = 0; i < texels.size(); ++i) {
            const double distance = distanceOfStored(plan, depths[i]);
            if (!std::isfinite(distance)) continue;
            const auto u = static_cast<double>(timeOf(glm::uvec2(texels[i].texel), static_cast<std::uint32_t>(layer)));
            marks.push_back({texels[i].xFrom, texels[i].xTo, u, u, distance, distance});
        }
    }
}

}  // namespace timeshade
