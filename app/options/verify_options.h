#pragma once

#include <optional>
#include <string>

#include "options/picture_options.h"
#include "options/run_options.h"

namespace timeshade {

/// `timeshade verify`: a technique against the oracle.
struct VerifyOptions : PictureOptions, RunOptions {
    std::string dump;              ///< folder for the data itself; empty for none
    std::optional<double> maxPpm;  ///< exit code 3 above it
    int referenceRays = 1024;      ///< rays a pixel of the shadow error's reference; 0 for none
};

}  // namespace timeshade
