#pragma once

#include <optional>
#include <string>

#include "scene_catalogue.h"

namespace timeshade {

/// What panels and keys ask for. It is done between two frames, when nobody refers to what it replaces.
struct Requests {
    std::optional<std::string> scene;   ///< a name or a path
    std::optional<SceneChoice> choice;  ///< of the file that is shown: another clip or light
    std::optional<GroundSettings> ground;
    std::optional<std::string> technique;
    std::optional<std::string> comparison;  ///< what to compare with, as --compare names it; empty: nothing
    std::optional<std::string> load;        ///< path of a settings file
    bool reload = false;                    ///< the shaders
    bool forget = false;                    ///< what techniques remember of frames before
    bool rebuild = false;                   ///< the recipe's settings have changed
    bool snapshot = false;                  ///< compare with a copy of the technique as it is set now
    bool swap = false;                      ///< swap A and B of the comparison
    bool fit = false;                       ///< make the window fit the file that is compared with
    bool screenshot = false;
    bool exr = false;        ///< the screenshot is to be an EXR
    bool recording = false;  ///< start or stop
    bool save = false;       ///< the settings
    bool command = false;    ///< the command line into the clipboard
    bool full = false;       ///< the full picture, now
    bool uncached = false;   ///< the picture without anything of frames before
    bool undo = false, redo = false;

    /// Something is to be replaced that a frame at work refers to.
    bool replaces() const {
        return scene || choice || ground || technique || comparison || load || reload || forget || rebuild ||
               snapshot || swap || recording || uncached || undo || redo;
    }
};

}  // namespace timeshade
