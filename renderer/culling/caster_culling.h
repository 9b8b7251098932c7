#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "culling/bounding_planes.h"
#include "culling/closed_surfaces.h"
#include "plan/frame_plan.h"

namespace timeshade {

/// Finds the casters of one frame that provably shadow no visible receiver that other casters do not shadow as well
/// (docs/numerics.md, "Culling of casters"). The plan and the surfaces must outlive it.
class CasterCulling {
  public:
    enum class Reason {
        None,             ///< not culled: it may cast a visible shadow
        FacingAway,       ///< a back face of a closed surface, seen from the light
        NoReceiverBehind  ///< it lies in a side of the scene's bounds that no receiver is behind
    };
    CasterCulling(const FramePlan& plan, const ClosedSurfaces& surfaces);
    Reason of(std::uint32_t triangle) const;

  private:
    const FramePlan& plan_;
    const ClosedSurfaces& surfaces_;
    std::vector<char> cullable_;  ///< ClosedSurfaces::facingAwayCullable
    BoundingPlanes boundingPlanes_;
};

/// The closed surfaces of a scene, found when they are first needed and again when a plan is of another scene.
class ClosedSurfaceCache {
  public:
    const ClosedSurfaces& of(const FramePlan& plan);

  private:
    std::shared_ptr<const RestPose> rest_;
    std::optional<ClosedSurfaces> surfaces_;
};

}  // namespace timeshade
