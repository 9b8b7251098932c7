#pragma once

#include <string>

namespace timeshade::gl {

/// What the current context says of itself. Every output names it.
struct DeviceInfo {
    std::string vendor;
    std::string renderer;
    std::string version;
    bool software = false;  ///< llvmpipe, softpipe, SwiftShader: milliseconds say nothing about a GPU
};

DeviceInfo currentDevice();

}  // namespace timeshade::gl
