#pragma once

#include <map>
#include <string>

#include "window/preview_quality.h"

namespace timeshade {

/// The window's surface: what is unfolded, visible and typed. Nothing in it changes the picture.
struct PanelState {
    bool visible = true;  ///< the panels as a whole
    bool keysVisible = false;
    bool storyVisible = false;  ///< the card that says what is shown at first
    bool storyClosed = false;   ///< for good
    std::string tab = "technique";
    float width = 0.0f;  ///< of the side panel, in units of the text's scale; 0 as at a first start
    PreviewQuality::Choice preview = PreviewQuality::Choice::Automatic;
    bool pageVisible = false;                              ///< of the technique
    std::map<std::string, bool> sections;                  ///< unfolded or not, where that is not as at a first start
    double textScale = 1.0;                                ///< the user's own, on top of the display's
    std::string scenePath;                                 ///< what is typed in the field of scenes
    std::string viewName;                                  ///< and of a view to be saved
    std::string comparePath;                               ///< and of pictures to compare with
    std::string sceneError;                                ///< one line, why the last one could not be opened
    std::string settingsPath = "timeshade-settings.json";  ///< what is typed in the field of settings files
    std::string lastCommand;                               ///< that was copied
};

}  // namespace timeshade
