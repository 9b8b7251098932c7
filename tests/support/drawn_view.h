#pragma once

#include <string>
#include <vector>

#include "frame/frame_renderer.h"

namespace timeshade {

/// The values of one of a technique's own views, row by row from the bottom: the frame is drawn with it, on buffers of
/// its own, and the view after the lookup. Needs the shared context.
std::vector<float> drawnView(const FramePlan& plan, Technique& technique, const std::string& name);

}  // namespace timeshade
