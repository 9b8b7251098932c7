#pragma once

#include "panels/widgets.h"
#include "window/layout.h"
#include "window/session.h"

namespace timeshade {

/// The column on the left with everything that can be set.
void drawSidePanel(Session& session, Widgets& widgets, const Area& area);
/// Play, step and scrub, and below that what the picture is and how far it has got.
void drawTransportBar(Session& session, Widgets& widgets, const Area& area);
/// What state the picture is in, in its upper right corner; a click leaves that state.
void drawChips(Session& session, Widgets& widgets, const Area& picture);
/// What is shown at the first start, in a few words.
void drawStory(Session& session, Widgets& widgets, const Area& picture);
/// What lies over the picture: why there is none, a notice, the list of keys.
void drawOverlays(Session& session, Widgets& widgets, const Area& picture);

/// The magnifier, and what each technique and the ground truth say of the pixel's samples.
void drawProbe(Session& session, Widgets& widgets, const Area& picture);

/// The sections of the side panel, from top to bottom.
void drawHeader(Session& session, Widgets& widgets);
void drawScenePanel(Session& session, Widgets& widgets);
void drawCasePanel(Session& session, Widgets& widgets);
void drawTechniquePanel(Session& session, Widgets& widgets);
void drawSamplingPanel(Session& session, Widgets& widgets);
void drawViewPanel(Session& session, Widgets& widgets);
void drawLightPanel(Session& session, Widgets& widgets);
void drawGroundPanel(Session& session, Widgets& widgets);
void drawCameraPanel(Session& session, Widgets& widgets);
void drawTimesPanel(Session& session, Widgets& widgets);
void drawAccuracyPanel(Session& session, Widgets& widgets);
void drawPlanPanel(Session& session, Widgets& widgets);
void drawTimePanel(Session& session, Widgets& widgets);
void drawComparePanel(Session& session, Widgets& widgets);
void drawSettingsPanel(Session& session, Widgets& widgets);

}  // namespace timeshade
