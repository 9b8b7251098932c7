#include "interactive.h"

#include "scene/error.h"

namespace timeshade {

int runInteractive(const Options&) { throw Error("the window is not there yet"); }

} // namespace timeshade
