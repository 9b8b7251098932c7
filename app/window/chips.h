#pragma once

#include <string>
#include <vector>

namespace timeshade {

struct Session;

/// A state of the window that a viewer must know of to read the picture, and that a click leaves.
struct Chip {
    std::string id;       ///< "preview"
    std::string text;     ///< "preview"
    std::string tooltip;  ///< what a click does
};

/// The states that the session is in, the most important first.
std::vector<Chip> chipsOf(const Session& session);
/// Leaves the state of that id.
void leaveState(Session& session, const std::string& id);

/// Closes or leaves what is on top: one thing. False where there is nothing.
bool closeTopmost(Session& session);

}  // namespace timeshade
