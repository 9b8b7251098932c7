#pragma once

#include <string>
#include <utility>
#include <vector>

#include "options/frame_options.h"

namespace timeshade {

/// Which light, how it is changed, the ground, and how radiance is shown, as pictureWords() has the rest.
void addLightWords(const FrameOptions& options, std::vector<std::pair<std::string, std::string>>& words);

/// Whether the option of that name takes one number.
bool isNumberOfLight(const std::string& key);

/// "azimuth 30, elevation 45 degrees, moves by ..."; empty where nothing is changed.
std::string inWords(const LightChange& change);
/// "exposure +1 stops, linear"; empty where it is the usual one.
std::string inWords(const DisplayLook& look);

const char* nameOf(ToneMap toneMap);
const char* nameOf(GroundChoice choice);

}  // namespace timeshade
