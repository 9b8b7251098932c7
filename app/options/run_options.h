#pragma once

#include <string>

#include "contexts/gl_context.h"

namespace CLI {
class App;
}

namespace timeshade {

/// Where OpenGL comes from, and what is reported of a run.
struct RunOptions {
    ContextOptions context;
    bool debugGl = false;     ///< fail on any message of the driver and on any value that is not finite
    bool explain = false;     ///< print the plan
    std::string json;         ///< path for a machine-readable report; empty for none
    std::string commandLine;  ///< as typed, for manifests
};

/// Declares --context, --device and --gl-debug on a command.
void declareContext(CLI::App& app, RunOptions& options);

/// Declares these, --explain and --json.
void declareOptions(CLI::App& app, RunOptions& options);

}  // namespace timeshade
