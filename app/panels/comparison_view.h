#pragma once

#include "panels/widgets.h"
#include "window/layout.h"
#include "window/session.h"

namespace timeshade {

/// Draws both techniques of a comparison into the picture's place, with seam and labels. Does nothing before the first
/// is there.
void drawComparison(Session& session, Widgets& widgets, const Area& area);

}  // namespace timeshade
