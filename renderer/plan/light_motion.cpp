#include "plan/light_motion.h"

#include <algorithm>

namespace timeshade {

LightMotion casterLists(const std::vector<TriangleMotion>& triangles, const ListRules& rules) {
    LightMotion lists;
    for (std::uint32_t id = 0; id < triangles.size(); ++id) {
        const TriangleMotion& triangle = triangles[id];
        if (triangle.light.reach == Reach::Outside) continue;
        if (!triangle.light.moves && !rules.allMove) {
            lists.staticCasters.push_back(id);
        } else if (rules.dropUnseenShadows && !triangle.shadowMayBeSeen) {
            continue;
        } else if (triangle.light.reachesNearPlane) {
            lists.nearPlane.push_back(id);
        } else {
            lists.dynamicCasters.push_back(id);
            if (triangle.nonTranslating) ++lists.nonTranslating;
        }
    }
    return lists;
}

std::vector<std::uint32_t> allOf(const LightMotion& lists) {
    std::vector<std::uint32_t> all;
    for (const auto* list : {&lists.staticCasters, &lists.dynamicCasters, &lists.nearPlane})
        all.insert(all.end(), list->begin(), list->end());
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace timeshade
