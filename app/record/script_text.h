#pragma once

#include <string>
#include <vector>

#include "settings_file.h"

namespace timeshade {

/// What a script says of one part; its settings are not yet read as options.
struct PartText {
    int frames = 0;     ///< 0 for one turn of the scene's motion
    double step = 1.0;  ///< frames of the scene per frame of the video
    std::string cameraTo, title, caption;
    std::vector<double> seams{0.5};
    std::string scene;
    std::vector<FileSetting> settings;
    std::string place;  ///< "F.json: part 2"
};

struct ScriptText {
    std::vector<FileSetting> common;  ///< settings of all parts
    std::vector<PartText> parts;      ///< at least one, at most 1,000
};

/// The script in a JSON text; `path` names the file in messages. Throws Error that names the part.
ScriptText scriptOfJson(const std::string& text, const std::string& path);

}  // namespace timeshade
