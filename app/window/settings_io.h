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

/// The same text, of the settings alone: neither which frame is shown nor the window's size. Equal texts, equal
/// settings, to the last bit.
std::string settingsText(Session& session);
/// Makes the window what such a text says; the frame that is shown stays. Throws Error and changes nothing.
void applySettingsText(Session& session, const std::string& text);

/// Makes the window what such a file says; what it does not mention is as at a start. Throws Error and changes nothing
/// where the file is wrong.
void loadSettings(Session& session, const std::string& path);

}  // namespace timeshade
