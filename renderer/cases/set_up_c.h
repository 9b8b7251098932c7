#pragma once

#include "cases/closed_form_cases.h"

namespace timeshade {

/// Makes the scenes of the catalogue: set-up C and what departs from it. Casters are added first, then `finish`.
class SetUpC {
  public:
    SetUpC();

    SetUpC& quad(const MovingQuad& caster);
    SetUpC& triangle(const MovingCorners& caster);
    /// The quad Q(c) at height z, its centre going from c0 to c1.
    SetUpC& slidingQuad(double c0, double c1, double z = 5.0, double halfX = 0.5);
    /// The quad Q(0) going from z0 to z1.
    SetUpC& risingQuad(double z0, double z1);
    SetUpC& light(const glm::dvec3& open, const glm::dvec3& close);
    /// Where the receiver's middle is at both ends.
    SetUpC& receiver(const glm::dvec3& open, const glm::dvec3& close);
    /// How far above the receiver the camera is. Nothing may come between.
    SetUpC& cameraHeight(double height);
    /// A point: the picture sees so small a square around it. Otherwise it sees a column, narrow in x, so that
    /// all pixels have the same answer, and tall in y, along which nothing depends, so that they see many map texels.
    SetUpC& point(double size);
    SetUpC& column(double height);
    /// No receiver is added: the last quad is it.
    SetUpC& receiverIsCaster();
    /// The receiver's half width in x, and how far the camera moves past it during the shutter.
    SetUpC& narrowReceiver(double halfX, double cameraTravel);
    /// Everything, the light included, this far away.
    SetUpC& offset(const glm::dvec3& by);

    /// Completes the case's scene and what the case says of its picture.
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
