#pragma once

#include <memory>

#include "options/frame_options.h"
#include "options/technique_options.h"
#include "plan/frame_request.h"
#include "scene/scene.h"
#include "scene_catalogue.h"
#include "technique/technique.h"

namespace timeshade {

/// Of what shows or judges camera samples one by one, each at its own time. Throws UsageError for interval samples;
/// `what` begins the line.
void requireStrata(const FrameOptions& options, const std::string& what);
/// Likewise for what takes a shutter of one linear piece.
void requireOneMotionStep(const FrameOptions& options, const std::string& what);

/// What the options choose of a file.
SceneChoice choiceOf(const FrameOptions& options);

/// What the options ask for, with the scene's own defaults where they are silent. Throws UsageError for a camera that
/// the scene does not have, and for the width of a response that has none.
FrameRequest requestFor(const FrameOptions& options, const Scene& scene);

/// Makes the options ask for this shutter's response; for its width only where that is not the usual one.
void setResponse(FrameOptions& options, const Shutter& shutter);

/// The request of one instant of this one's shutter, u in [0, 1]: as long as an instant, so that nothing is blurred.
FrameRequest atInstant(const FrameRequest& request, double u);

/// The technique of that name with those of the settings that are its own. Throws UsageError.
std::unique_ptr<Technique> techniqueFor(const std::string& name, const SettingTexts& settings,
                                        gl::ProgramCache& programs);

/// The technique that the options name, with their settings.
std::unique_ptr<Technique> techniqueFor(const TechniqueOptions& options, gl::ProgramCache& programs);

}  // namespace timeshade
