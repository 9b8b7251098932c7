#pragma once

#include "scene/camera.h"
#include "scene/light.h"
#include "scene/scene.h"

namespace timeshade {

/// A camera for a scene that has none: a three-quarter view from above with all of the bounds inside a 4:3 picture.
CameraPose fittedCamera(const Bounds& bounds);

/// A spot light for a scene that has none: from the upper left, all of the bounds inside its cone, bright enough
/// that a white surface at the centre that faces it reflects a radiance of about 1.
LightPose fittedLight(const Bounds& bounds);

}  // namespace timeshade
