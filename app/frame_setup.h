#pragma once

#include <memory>

#include "options.h"
#include "plan/frame_request.h"
#include "scene/scene.h"
#include "technique/technique.h"

namespace timeshade {

/// What the options ask for, with the scene's own defaults where they are silent. Throws UsageError for a camera that
/// the scene does not have.
FrameRequest requestFor(const Options& options, const Scene& scene);

/// The request of one instant of this one's shutter, u in [0, 1]: as long as an instant, so that nothing is blurred.
FrameRequest atInstant(const FrameRequest& request, double u);

/// The technique that the options name, with their settings.
std::unique_ptr<Technique> techniqueFor(const Options& options, gl::ProgramCache& programs);

}  // namespace timeshade
