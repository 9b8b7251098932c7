#include "scene/inner_motion.h"

#include <algorithm>
#include <array>

namespace timeshade {

std::vector<double> innerInstants(std::vector<double> keys) {
    std::erase_if(keys, [](double u) { return !(u > 0.0 && u < 1.0); });
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    constexpr std::array<double, 3> always{0.25, 0.5, 0.75};
    constexpr std::size_t most = mostInnerInstants - always.size();
    if (keys.size() > most) {
        for (std::size_t i = 0; i < most; ++i) keys[i] = keys[i * keys.size() / most];
        keys.resize(most);
    }
    keys.insert(keys.end(), always.begin(), always.end());
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
}

std::vector<std::uint32_t> extremesOf(const std::vector<glm::vec3>& points, const std::vector<std::uint32_t>& among) {
    std::vector<std::uint32_t> extremes;
    if (among.empty()) return extremes;
    constexpr std::array<std::array<float, 3>, 7> ways{
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, -1}}};
    for (const auto& [x, y, z] : ways) {
        const glm::vec3 way(x, y, z);
        const auto [least, most] = std::minmax_element(
            among.begin(), among.end(),
            [&](std::uint32_t a, std::uint32_t b) { return glm::dot(points[a], way) < glm::dot(points[b], way); });
        extremes.insert(extremes.end(), {*least, *most});
    }
    std::sort(extremes.begin(), extremes.end());
    extremes.erase(std::unique(extremes.begin(), extremes.end()), extremes.end());
    return extremes;
}

}  // namespace timeshade
