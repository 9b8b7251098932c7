#include "options/list_options.h"

#include "options/command_parts.h"

namespace timeshade {

void addListCommand(CLI::App& app, Command& command) {
    CLI::App* list = app.add_subcommand("list", "scenes, techniques and their settings");
    auto reading = std::make_shared<CommandReading<ListOptions>>();
    list->add_flag("--json", reading->options.json, "as JSON");
    list->add_flag("--devices", reading->options.devices, "the EGL devices of this machine");
    whenRead(*list, command, reading, [](CommandReading<ListOptions>&) {});
}

}  // namespace timeshade
