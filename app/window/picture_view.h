#pragma once

#include "panels/widgets.h"
#include "window/layout.h"

namespace timeshade {

struct Session;

/// Draws what is shown into its place behind the panels: the picture, a diagnostic of it, or two in comparison.
void drawPictureView(Session& session, Widgets& widgets, const Area& area);

}  // namespace timeshade
