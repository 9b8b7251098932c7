#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "culling/bounding_planes.h"
#include "culling/closed_surfaces.h"
#include "plan/frame_plan.h"

namespace timeshade {

/// Casters that can make no difference to any receiver, by proof (ClosedSurfaces, BoundingPlanes). Of one frame; the
/// plan must outlive it.
class CasterCulling {
  public:
    enum class Reason {
        None,             ///< it may cast a shadow that is seen
        FacingAway,       ///< it faces away from the light on a closed surface, which is hidden by what faces the light
        NoReceiverBehind  ///< nothing lies behind it, seen from the light
    };
    CasterCulling(const FramePlan& plan, const ClosedSurfaces& surfaces);
    Reason of(std::uint32_t triangle) const;

  private:
    const FramePlan& plan_;
    const ClosedSurfaces& surfaces_;
    std::vector<char> cullable_;  ///< ClosedSurfaces::facingAwayCullable
    BoundingPlanes boundingPlanes_;
};

/// The closed surfaces of the scene that was planned last: found when a technique first needs them, and not again until
/// the scene is another one.
class ClosedSurfaceCache {
  public:
    const ClosedSurfaces& of(const FramePlan& plan);

  private:
    std::shared_ptr<const RestPose> rest_;
    std::optional<ClosedSurfaces> surfaces_;
};

}  // namespace timeshade
