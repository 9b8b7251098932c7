#include "plan/map_line.h"

#include <algorithm>
#include <cmath>

namespace timeshade {

namespace {

/// From world space less the origin to the light's view coordinates, which are linear in u.
glm::dmat4 viewFromWorld(const FramePlan& plan, double u) {
    return glm::dmat4(plan.light.block.viewFromWorldOpen) * (1.0 - u) +
           glm::dmat4(plan.light.block.viewFromWorldClose) * u;
}

}  // namespace

double MapLine::alongOf(const glm::dvec2& place) const {
    const glm::dvec2 way = to - from;
    return glm::dot(place - from, way) / glm::dot(way, way);
}

double MapLine::texelsFrom(const glm::dvec2& place, const glm::dvec2& size) const {
    return glm::length((place - at(alongOf(place))) * size);
}

std::vector<TexelOnLine> texelsAlong(const MapLine& line, const glm::ivec2& size) {
    // Where the line enters another column or row.
    std::vector<double> borders{0.0, 1.0};
    for (int axis = 0; axis < 2; ++axis) {
        const double from = line.from[axis] * size[axis], to = line.to[axis] * size[axis];
        if (from == to) continue;
        const auto last = static_cast<int>(std::floor(std::max(from, to)));
        for (int border = static_cast<int>(std::ceil(std::min(from, to))); border <= last; ++border)
            borders.push_back(std::clamp((border - from) / (to - from), 0.0, 1.0));
    }
    std::sort(borders.begin(), borders.end());
    std::vector<TexelOnLine> texels;
    for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
        if (!(borders[i] < borders[i + 1])) continue;
        const glm::ivec2 texel(glm::floor(line.at(0.5 * (borders[i] + borders[i + 1])) * glm::dvec2(size)));
        const bool inside =
            glm::all(glm::greaterThanEqual(texel, glm::ivec2(0))) && glm::all(glm::lessThan(texel, size));
        if (!inside) continue;
        // Two borders that are one but for rounding leave a sliver of the texel before or behind.
        if (!texels.empty() && texels.back().texel == texel)
            texels.back().xTo = borders[i + 1];
        else
            texels.push_back({texel, borders[i], borders[i + 1]});
    }
    return texels;
}

MapPlace mapPlaceOf(const FramePlan& plan, const glm::dvec3& position, double u) {
    const glm::dvec3 v(viewFromWorld(plan, u) * glm::dvec4(position, 1.0));
    const bool orthographic = plan.light.projection == Projection::Orthographic;
    return {orthographic ? glm::dvec2(v) : glm::dvec2(v) / v.z, v.z};
}

LightRay lightRayThrough(const FramePlan& plan, const glm::dvec2& place, double u) {
    const glm::dmat4 world = glm::inverse(viewFromWorld(plan, u));
    const bool orthographic = plan.light.projection == Projection::Orthographic;
    const glm::dvec4 from = orthographic ? glm::dvec4(place, 0.0, 1.0) : glm::dvec4(0.0, 0.0, 0.0, 1.0);
    const glm::dvec4 way = orthographic ? glm::dvec4(0.0, 0.0, 1.0, 0.0) : glm::dvec4(place, 1.0, 0.0);
    return {glm::dvec3(world * from), glm::dvec3(world * way)};
}

}  // namespace timeshade
