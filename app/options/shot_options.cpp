#include "options/shot_options.h"

#include "core/error.h"
#include "options/command_parts.h"

namespace timeshade {

namespace {

void finish(CommandReading<ShotOptions>& read) {
    const std::string& path = read.options.output;
    const bool piped = path == "-";
    const bool known = piped || (path.size() > 4 && (path.ends_with(".png") || path.ends_with(".exr")));
    if (!known)
        throw UsageError(
            fmt::format("-o {}: expected a name that ends in .png or .exr, or - for a PNG to standard output", path));
    if (piped && read.options.frames.value_or(1) != 1)
        throw UsageError(fmt::format("--frames {}: standard output takes one picture; expected 1, or -o F.png",
                                     *read.options.frames));
    checkDrawing(read, {.comparisons = true, .diagnostics = !path.ends_with(".exr"), .techniqueViews = true}, path);
}

}  // namespace

void addShotCommand(CLI::App& app, Command& command) {
    CLI::App* shot = app.add_subcommand("shot", "draw a picture without a window");
    auto reading = std::make_shared<CommandReading<ShotOptions>>();
    declareScene(*shot, reading->options.scene)->required();
    shot->add_option("-o,--output", reading->options.output, "F.png or F.exr; - for a PNG to standard output")
        ->required();
    shot->add_option("--frames", reading->options.frames, "number of frames to draw, one file each (F.0000.png, ...)")
        ->check(numberFrom(1, 100000));
    declareDrawing(*shot, *reading);
    whenRead(*shot, command, reading, finish);
}

}  // namespace timeshade
