#pragma once

#include <string>

#include "options/picture_options.h"

namespace timeshade {

struct Session;

/// What the window shows, as options: drawn headless they give the picture that it shows when nothing moves. Of
/// settings only those of the technique and the scene that are not at their defaults.
PictureOptions pictureOptions(Session& session);

/// The command that draws it.
std::string commandOf(Session& session);

/// Everything in the window as a settings file: also other techniques' and scenes' settings, and text size, panels and
/// saved views. Throws Error.
void saveSettings(Session& session, const std::string& path);

/// Makes the window what such a file says; what it does not mention is as at a start. Throws Error and changes nothing
/// where the file is wrong.
void loadSettings(Session& session, const std::string& path);

}  // namespace timeshade
