#pragma once

namespace timeshade {

struct Session;
class UiDump;

/// Writes what the session shows into the dump, for scripts that drive the window.
void dumpState(Session& session, UiDump& dump);

}  // namespace timeshade
