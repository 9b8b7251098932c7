#include "plan/light_motion.h"

namespace timeshade {

LightMotion casterLists(const std::vector<TriangleMotion>& triangles, const ListRules& rules) {
    LightMotion lists;
    for (std::uint32_t id = 0; id < triangles.size(); ++id) {
        const TriangleMotion& triangle = triangles[id];
        if (triangle.light.reach == Reach::Outside) continue;
        if (!triangle.light.moves && !rules.allMove) {
            lists.still.push_back(id);
        } else if (rules.dropUnseenShadows && !triangle.shadowMayBeSeen) {
            continue;
        } else if (triangle.light.reachesNearPlane) {
            lists.nearPlane.push_back(id);
        } else {
            lists.moving.push_back(id);
            if (triangle.bends) ++lists.bending;
        }
    }
    return lists;
}

} // namespace timeshade
