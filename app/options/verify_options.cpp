#include "options/verify_options.h"

#include "options/command_parts.h"

namespace timeshade {

void addVerifyCommand(CLI::App& app, Command& command) {
    CLI::App* verify = app.add_subcommand("verify", "compare every camera sample with the ray-traced truth");
    auto reading = std::make_shared<CommandReading<VerifyOptions>>();
    VerifyOptions& options = reading->options;
    declareScene(*verify, options.scene)->required();
    verify->add_option("--dump", options.dump, "folder for the data itself: triangles.csv, light.csv, samples.csv");
    verify
        ->add_option("--max-ppm", options.maxPpm,
                     "exit with 3 if more samples in a million disagree; for techniques that look at an instant at a "
                     "point")
        ->check(CLI::Range(0.0, 1e6));
    verify
        ->add_option("--reference-rays", options.referenceRays,
                     "rays a pixel of the converged visibility that shadow errors are measured against (default: 1024, "
                     "cached between runs; 0: no shadow error)")
        ->check(CLI::Range(0, 1 << 20));
    declareDrawing(*verify, *reading);
    whenRead(*verify, command, reading, [](CommandReading<VerifyOptions>& read) { checkDrawing(read, {}, ""); });
}

}  // namespace timeshade
