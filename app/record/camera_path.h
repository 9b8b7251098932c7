#pragma once

#include "scene/camera.h"

namespace timeshade {

/// The pose on the way from one to another: eye, field of view and nearest distance evenly, the direction along the
/// shortest turn.
CameraPose between(const CameraPose& from, const CameraPose& to, double share);

}  // namespace timeshade
