#include "options/view_options.h"

#include "options/command_parts.h"

namespace timeshade {

void addViewCommand(CLI::App& app, Command& command) {
    CLI::App* view = app.add_subcommand("view", "open the window");
    auto reading = std::make_shared<CommandReading<ViewOptions>>();
    declareScene(*view, reading->options.scene);
    declareDrawing(*view, *reading);
    whenRead(*view, command, reading, [](CommandReading<ViewOptions>& read) {
        checkDrawing(read, {.comparisons = true, .diagnostics = true, .techniqueViews = true}, "");
    });
}

}  // namespace timeshade
