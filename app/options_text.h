#pragma once

#include <string>
#include <vector>

#include "core/setting.h"
#include "options/picture_options.h"

namespace timeshade {

/// It is not at its default.
bool isChanged(const Setting& setting);

/// Fourteen numbers for --pose, exactly: eye, right, up, back, vertical field of view in radians, nearest distance.
std::string textOf(const CameraPose& pose);
/// Throws UsageError unless it is fourteen numbers that make a camera: axes at right angles and of length 1 within
/// 1e-6.
CameraPose poseFromText(const std::string& text);

/// One setting of a picture: "spp", "8".
using PictureWord = std::pair<std::string, std::string>;

/// All that decides a picture, as long options without dashes; settings of techniques and scenes stand in
/// options.settings. What is as at the start is left out, but for scene, technique, size and what a scene has defaults
/// of its own for.
std::vector<PictureWord> pictureWords(const PictureOptions& options);

/// "timeshade shot chess --technique=... -o picture.png", for a shell.
std::string shotCommand(const PictureOptions& options, const std::string& output);

/// The same as a settings file. `windowState` is a JSON object of what is the window's alone, or empty.
std::string settingsJson(const PictureOptions& options, const std::string& windowState);

}  // namespace timeshade
