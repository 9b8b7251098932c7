#include "options/pictures_options.h"

#include "options/command_parts.h"

namespace timeshade {

void addPicturesCommand(CLI::App& app, Command& command) {
    CLI::App* pictures =
        app.add_subcommand("pictures", "draw every built-in scene into a folder, with a table of times");
    auto reading = std::make_shared<CommandReading<PicturesOptions>>();
    pictures->add_option("-o,--output", reading->options.output, "folder")->required();
    declareDrawing(*pictures, *reading);
    whenRead(*pictures, command, reading, [](CommandReading<PicturesOptions>& read) {
        checkDrawing(read, {.comparisons = true, .techniqueViews = true}, read.options.output);
        requireTechniques(read.options, "pictures of scenes come with times of techniques");
    });
}

}  // namespace timeshade
