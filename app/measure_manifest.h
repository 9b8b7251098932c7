#pragma once

#include <string>
#include <vector>

#include "headless_gl.h"
#include "measure/sweep.h"
#include "measure/sweep_manifest.h"
#include "options/measure_options.h"

namespace timeshade {

/// All of a manifest but the plans. `techniques`: TechniqueVariants, and "embree".
SweepManifest manifestOf(const MeasureOptions& options, const std::vector<std::string>& techniques,
                         const HeadlessGl& opengl, const FrameRenderer& renderer);

/// What moves in a scene's shutter and which passes follow, for the first technique measured.
std::vector<std::string> planLines(const SweepScene& scene, const std::string& technique, const gl::DeviceInfo& device,
                                   gl::ProgramCache& programs);

}  // namespace timeshade
