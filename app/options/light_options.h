#pragma once

#include "options/frame_options.h"

namespace timeshade {

/// Declares which light there is, where it is, how strong and how it moves; parts of declareOptions(FrameOptions).
void declareLight(CLI::App& app, FrameOptions& options);
/// Declares the ground of files.
void declareGround(CLI::App& app, FrameOptions& options);
/// Declares how radiance is shown.
void declareLook(CLI::App& app, FrameOptions& options);

/// Throws UsageError where the options ask of a sun what only a spot has; `scene` names it.
void requireLightHas(const LightPose& light, const LightChange& change, const std::string& scene);

}  // namespace timeshade
