#include "technique/stored_along_line.h"

#include <cmath>
#include <limits>

#include "gl/read_back.h"

namespace timeshade {

double distanceOfStored(const FramePlan& plan, float stored) {
    if (!(stored > 0.0f)) return std::numeric_limits<double>::infinity();
    const shared::ViewBlock& view = plan.light.block;
    if (plan.light.projection == Projection::Orthographic)
        return (1.0 - static_cast<double>(stored)) * static_cast<double>(view.farDistance);
    return static_cast<double>(view.nearDistance) / static_cast<double>(stored);
}

std::vector<float> valuesAlong(const gl::Texture& map, int layer, const std::vector<TexelOnLine>& texels) {
    if (texels.empty()) return {};
    glm::ivec2 low = texels.front().texel, high = low;
    for (const TexelOnLine& t : texels) {
        low = glm::min(low, t.texel);
        high = glm::max(high, t.texel);
    }
    const glm::ivec2 size = high - low + 1;
    std::vector<float> values(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    const GLenum format = map.format() == GL_DEPTH_COMPONENT32F ? GL_DEPTH_COMPONENT : GL_RED;
    gl::readTexels(map, {low.x, low.y, layer, size.x, size.y}, format, GL_FLOAT, values);
    std::vector<float> along;
    along.reserve(texels.size());
    for (const TexelOnLine& t : texels) {
        const glm::ivec2 place = t.texel - low;
        along.push_back(values[static_cast<std::size_t>(place.y) * static_cast<std::size_t>(size.x) +
                               static_cast<std::size_t>(place.x)]);
    }
    return along;
}

void addMapMarks(const FramePlan& plan, const gl::Texture& map, const MapLine& line, double uFrom, double uTo,
                 std::vector<StoredMark>& marks) {
    const std::vector<TexelOnLine> texels = texelsAlong(line, {map.width(), map.height()});
    const std::vector<float> stored = valuesAlong(map, 0, texels);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const double distance = distanceOfStored(plan, stored[i]);
        if (!std::isfinite(distance)) continue;
        StoredMark mark{texels[i].xFrom, texels[i].xTo, uFrom, uTo, distance, distance};
        marks.push_back(mark);
    }
}

}  // namespace timeshade
