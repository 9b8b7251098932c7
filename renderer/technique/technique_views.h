#pragma once

#include <string>

#include "technique/technique.h"

namespace timeshade {

/// The technique's own view of that name. Throws UsageError that lists those that it has.
TechniqueView viewOf(const Technique& technique, const std::string& name);

}  // namespace timeshade
