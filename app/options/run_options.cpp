#include "options/run_options.h"

#include <CLI/CLI.hpp>

#include "options/option_checks.h"

namespace timeshade {

void declareContext(CLI::App& app, RunOptions& options) {
    app.add_option("--context", options.context.kind, "auto, window, egl, osmesa")
        ->transform(oneOf<ContextKind>({{"auto", ContextKind::Auto},
                                        {"window", ContextKind::Window},
                                        {"egl", ContextKind::Egl},
                                        {"osmesa", ContextKind::OsMesa}}))
        ->multi_option_policy(lastWins);
    app.add_option("--device", options.context.device, "number of an EGL device (list --devices)")
        ->check(numberFrom(0, 1000))
        ->multi_option_policy(lastWins);
    app.add_flag("--gl-debug", options.debugGl,
                 "fail on anything that the driver complains of, and on a NaN or an infinity in any buffer");
}

void declareOptions(CLI::App& app, RunOptions& options) {
    declareContext(app, options);
    app.add_flag("--explain", options.explain, "print the plan: which passes run, and why");
    app.add_option("--json", options.json, "write a report of the frame")
        ->check(notEmpty("a file name"))
        ->multi_option_policy(lastWins);
}

}  // namespace timeshade
