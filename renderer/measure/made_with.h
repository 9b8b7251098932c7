#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gl/device_info.h"
#include "plan/frame_request.h"
#include "scene/scene.h"
#include "technique/technique.h"

namespace timeshade {

/// Everything that a measured row depends on, as named parts: "model", "frame", "shaders" ... Two rows whose parts are
/// equal are the same measurement; a part that differs says why they are not.
using MadeWith = std::vector<std::pair<std::string, std::string>>;

/// The program (its commit and its binary), and the text of all shaders.
MadeWith madeWithBinary(const std::string& commit);

/// What is the same for a whole sweep: the same, and the device.
MadeWith madeWithProgram(const std::string& commit, const gl::DeviceInfo& device);

/// The scene's content and clip, and every field of the request.
MadeWith madeWithScene(const Scene& scene, const FrameRequest& request);

/// All settings of a technique.
std::string settingsText(Technique& technique);

/// Names of the parts that differ, or are in one of them alone.
std::vector<std::string> differingParts(const MadeWith& a, const MadeWith& b);

}  // namespace timeshade
