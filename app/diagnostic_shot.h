#pragma once

#include "frame/frame_renderer.h"
#include "options/technique_options.h"

namespace timeshade {

/// The picture that `--view error` or `--view disagreement` asks for: how far a frame is from its ray-traced reference
/// (cached), or which of its camera samples were answered wrongly. Draws the frame itself.
DisplayImage drawDiagnostic(FrameRenderer& renderer, const FramePlan& plan, Technique& technique,
                            Diagnostic diagnostic);

}  // namespace timeshade
