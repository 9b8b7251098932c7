#pragma once

#include <string>

#include "core/setting.h"
#include "panels/widgets.h"

namespace timeshade {

/// A slider or a switch for every setting of a technique or a scene, and a button that resets them all where one is not
/// at its default. The controls are named like the settings on the command line. True when a value has changed.
bool drawSettings(HasSettings& owner, const std::string& resetId, Widgets& widgets);

}  // namespace timeshade
