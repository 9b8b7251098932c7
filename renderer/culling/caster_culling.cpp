#include "culling/caster_culling.h"

#include "core/check.h"

namespace timeshade {

CasterCulling::CasterCulling(const FramePlan& plan, const ClosedSurfaces& surfaces)
    : plan_(plan),
      surfaces_(surfaces),
      cullable_(surfaces.facingAwayCullable(*plan.mesh, plan.origin, plan.camera, plan.light)),
      boundingPlanes_(plan.extent, plan.block, plan.light) {}

CasterCulling::Reason CasterCulling::of(std::uint32_t triangle) const {
    CHECK_LT(triangle, plan_.triangles->size());
    CHECK_LT(triangle, surfaces_.ofTriangles().size());
    // Under a sun that turns, what a triangle that moves shows it in between does not follow from both ends.
    const bool known = plan_.light.projection == Projection::Perspective || plan_.motion.lightTurnDegrees == 0.0;
    const bool away = known && (*plan_.triangles)[triangle].light.facing == Facing::Away;
    if (away && cullable_[surfaces_.ofTriangles()[triangle]] != 0) return Reason::FacingAway;
    return boundingPlanes_.holds(plan_.texels->positions, triangle) ? Reason::NoReceiverBehind : Reason::None;
}

const ClosedSurfaces& ClosedSurfaceCache::of(const FramePlan& plan) {
    if (rest_ != plan.rest || !surfaces_) {
        rest_ = plan.rest;
        surfaces_.emplace(rest_->mesh(), *plan.materials);
    }
    return *surfaces_;
}

}  // namespace timeshade
