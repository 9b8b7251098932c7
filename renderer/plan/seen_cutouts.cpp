#include "plan/seen_cutouts.h"

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade {

void refuseSeenCutouts(const FramePlan& plan) {
    if (!plan.cutouts) return;
    for (const TriangleLists* lists : {&plan.camera.staticTriangles, &plan.camera.dynamicTriangles})
        for (const auto* list : {&lists->small, &lists->large})
            for (const std::uint32_t id : *list)
                if (isCutOut(plan, id))
                    throw Error(
                        fmt::format("the material \"{}\" is cut out by its alpha, which has no edges to solve "
                                    "for; expected --samples strata where the camera sees it",
                                    (*plan.materials)[plan.mesh->topology->triangleMaterials[id]].name));
}

}  // namespace timeshade
