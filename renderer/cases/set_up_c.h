#pragma once

#include "cases/closed_form_cases.h"

namespace timeshade {

/// Builds the scenes of the catalogue: set-up C (ClosedFormCase) with changes. Add casters first, then call `finish`.
class SetUpC {
  public:
    SetUpC();

    SetUpC& quad(const MovingQuad& caster);
    SetUpC& triangle(const MovingCorners& caster);
    /// The quad Q(c) at height z; its centre moves from x = c0 to c1.
    SetUpC& slidingQuad(double c0, double c1, double z = 5.0, double halfX = 0.5);
    /// The quad Q(0) moving from z0 to z1.
    SetUpC& risingQuad(double z0, double z1);
    SetUpC& light(const glm::dvec3& open, const glm::dvec3& close);
    /// The receiver's centre at both ends.
    SetUpC& receiver(const glm::dvec3& open, const glm::dvec3& close);
    /// The camera's height above the receiver. Nothing may come between them.
    SetUpC& cameraHeight(double height);
    /// The picture shows a square of this size around the receiver's centre. Without it, the picture shows a column
    /// that is narrow in x, so that all pixels have the same visibility, and tall in y, on which visibility does not
    /// depend, so that it covers many map texels.
    SetUpC& point(double size);
    SetUpC& column(double height);
    /// Adds no receiver; the last quad is the receiver.
    SetUpC& receiverIsCaster();
    /// The receiver's half width in x, and the camera's displacement past it during the shutter.
    SetUpC& narrowReceiver(double halfX, double cameraTravel);
    /// Translates everything, the light included.
    SetUpC& offset(const glm::dvec3& by);

    /// Completes the case's scene and its description of the picture.
    void finish(ClosedFormCase& c);

  private:
    LightPose lightAt(const glm::dvec3& position) const;
    CameraPose cameraOver(const glm::dvec3& point) const;

    ProceduralScene scene_;
    glm::dvec3 lightOpen_{0.0, 0.0, 10.0}, lightClose_{0.0, 0.0, 10.0};
    glm::dvec3 receiverOpen_{0.0}, receiverClose_{0.0}, offset_{0.0};
    double height_ = 1.0, patchHeight_ = 1.4;
    double receiverHalfX_ = 0.2, cameraTravel_ = 0.0;
    bool isPoint_ = false, receiverIsCaster_ = false;
};

}  // namespace timeshade
