#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "gl/device_info.h"

namespace timeshade {

/// What stands beside every number: enough to measure it again.
struct SweepManifest {
    std::string commandLine;
    std::string commit;  ///< of the program; "unknown" outside a checkout
    std::string processor;
    std::string backEnd;
    gl::DeviceInfo device;
    std::vector<std::string> settings;  ///< "tsm.bias = 0.5", every setting of every technique measured
    std::map<std::string, std::vector<std::string>> plans;  ///< scene to its plan in words, a line each
};

nlohmann::ordered_json asJson(const SweepManifest& manifest);

/// "llvmpipe ... through EGL; processor; commit": one line, which ends in a full stop.
std::string inOneLine(const SweepManifest& manifest);

}  // namespace timeshade
