#pragma once

#include <string>
#include <vector>

#include "options/record_options.h"

namespace timeshade {

/// A stretch of a recording without a cut.
struct ScriptPart {
    PictureOptions drawn;            ///< scene, techniques, first frame and all else of a picture
    int frames = 0;                  ///< 0 for one turn of the scene's motion
    double step = 1.0;               ///< frames of the scene per frame of the video: below 1 is slow motion
    std::string cameraTo;            ///< the camera travels to this one; empty where it does not
    std::vector<double> seams{0.5};  ///< where a wipe's seam goes, evenly in time, with ease
    std::string title, caption;      ///< along the lower edge; may be empty
};

/// The parts that `--script` names, each drawn with the options of the command line, which win; or the options as the
/// only part. A script is a JSON object {"options": {...}, "parts": [...]}; the options hold for every part, and a part
/// holds what a settings file may and "frames", "step", "camera_to", "seam" (a number or an array of them), "title",
/// "caption". Throws Error or UsageError that name the file and the part.
std::vector<ScriptPart> partsOf(const RecordOptions& options);

/// The value at `share` (0 to 1) of a way through all of the values, slow at each.
double easedThrough(const std::vector<double>& values, double share);

/// Slow at both ends: 0 to 1 for 0 to 1.
double eased(double share);

}  // namespace timeshade
