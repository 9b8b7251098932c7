#pragma once

#include <string>

namespace timeshade {

struct Session;

/// What the picture that is shown is, as it was drawn, whatever has been set since:
/// "Preview 320 x 240, 4 spp, map 1024, 12 ms".
std::string statusOf(const Session& session);

}  // namespace timeshade
