#pragma once

#include <optional>

#include "plan/frame_request.h"
#include "scene/light_change.h"
#include "scene/scene.h"

namespace timeshade {

/// The scene's light in one piece of a request's shutter, with the request's change.
class PlannedLight {
  public:
    /// `times`: of the scene in that piece (shutterTimes()). The scene must outlive this.
    PlannedLight(const Scene& scene, const FrameRequest& request, const ShutterTimes& times, int piece, int pieces);

    ShutterEnds<LightPose> ends() const;
    LightPose middle() const;
    /// At u of the piece, as it is at that instant: what jumps has jumped.
    LightPose at(double u) const;

  private:
    LightPose changedAt(const LightPose& own, double u) const;

    const Scene& scene_;
    const LightChange& change_;
    ShutterTimes times_;
    LightPose atOwnFrame_;
    double firstFrame_ = 0.0, frames_ = 0.0;  ///< after the scene's own: the piece's opening, and how long it is
};

/// What makes the scene's light as bright as pictures are made for, whatever the file's units: with it, a white diffuse
/// surface at the scene's centre that faces the light at the scene's own frame has radiance 2.6, if the light is as
/// strong as it ever gets. Fixed per scene and place of the light; a change of intensity is seen.
double exposureOf(const Scene& scene, const LightChange& change);

}  // namespace timeshade
