#pragma once

#include <memory>
#include <string>
#include <vector>

#include "technique/technique.h"

namespace timeshade {

/// All techniques, in the order in which they are shown. Needs no OpenGL.
const std::vector<TechniqueDescription>& techniqueDescriptions();

/// The one of that name. Throws UsageError that lists the known names.
const TechniqueDescription& techniqueDescription(const std::string& name);

/// Throws likewise. OpenGL is touched only when the technique draws, so that settings can
/// be listed and parsed without a context; `programs` must outlive the technique.
std::unique_ptr<Technique> makeTechnique(const std::string& name, gl::ProgramCache& programs);

}  // namespace timeshade
