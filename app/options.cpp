#include "options.h"

#include <fstream>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "scene/error.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

void parseSize(const std::string& text, Options& options) {
    int width = 0, height = 0;
    char rest = '\0';
    if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 1 || height < 1 || width > maximumImageSide ||
        height > maximumImageSide)
        throw UsageError(fmt::format("--size {}: expected WIDTHxHEIGHT, each from 1 to {}", text, maximumImageSide));
    options.width = width;
    options.height = height;
}

void parseSetting(const std::string& text, Options& options) {
    const std::size_t equals = text.find('=');
    const std::size_t dot = text.find('.');
    if (equals == std::string::npos || dot == std::string::npos || dot > equals || dot == 0)
        throw UsageError(fmt::format("--set {}: expected TECHNIQUE.KEY=VALUE, as in tsm.bias=0.5", text));
    options.settings.emplace_back(text.substr(0, equals), text.substr(equals + 1));
}

/// Settings are checked at once against the registry, so that a typing error costs no rendering.
void checkSettings(const Options& options) {
    gl::ProgramCache programs;
    makeTechnique(options.technique, programs);
    for (const auto& [name, value] : options.settings) {
        const std::size_t dot = name.find('.');
        setFromText(*makeTechnique(name.substr(0, dot), programs), name.substr(dot + 1), value);
    }
}

/// A settings file is a JSON object: keys are the long options without their dashes, and "set" an object of technique
/// settings. It is turned into arguments that come before those of the command line, which therefore win.
std::vector<std::string> argumentsOfFile(const std::string& path) {
    std::ifstream stream(path);
    if (!stream) throw Error(fmt::format("{}: cannot be read; expected a JSON file of settings", path));
    nlohmann::json json;
    try {
        json = nlohmann::json::parse(stream);
    } catch (const nlohmann::json::exception&) {
        throw Error(fmt::format("{}: is not JSON; expected an object of settings", path));
    }
    if (!json.is_object()) throw Error(fmt::format("{}: holds a JSON {}; expected an object of settings", path, json.type_name()));
    const auto text = [](const nlohmann::json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); };
    std::vector<std::string> arguments;
    for (const auto& [key, value] : json.items()) {
        if (key == "set" && value.is_object()) {
            for (const auto& [name, setting] : value.items()) {
                arguments.push_back("--set");
                arguments.push_back(name + "=" + text(setting));
            }
        } else if (value.is_primitive() && !value.is_null()) {
            arguments.push_back("--" + key);
            arguments.push_back(text(value));
        } else {
            throw Error(fmt::format("{}: \"{}\" is {}; expected a number, a string or a switch", path, key, value.type_name()));
        }
    }
    return arguments;
}

void addFrameOptions(CLI::App& app, Options& options, std::string& size, std::vector<std::string>& settings) {
    const std::map<std::string, ContextKind> contexts{
        {"auto", ContextKind::Auto}, {"window", ContextKind::Window}, {"egl", ContextKind::Egl}, {"osmesa", ContextKind::OsMesa}};
    const std::map<std::string, View> views{{"final", View::Final}, {"visibility", View::Visibility}};
    const std::map<std::string, ShutterPosition> positions{
        {"start", ShutterPosition::Start}, {"centre", ShutterPosition::Centre}, {"end", ShutterPosition::End}};
    const auto last = CLI::MultiOptionPolicy::TakeLast;
    app.add_option("--technique", options.technique, "static, tsm, accumulation")->multi_option_policy(last);
    app.add_option("--spp", options.samplesPerPixel, "camera samples per pixel, one per stratum of the shutter")
        ->check(CLI::Range(1, maximumSamplesPerPixel))->multi_option_policy(last);
    app.add_option("--size", size, "WIDTHxHEIGHT of the picture")->multi_option_policy(last);
    app.add_option("--map", options.mapSize, "texels along a side of the light's map")
        ->check(CLI::Range(minimumMapSize, maximumMapSize))->multi_option_policy(last);
    auto* frame = app.add_option("--frame", options.frame, "number of the frame (default: the scene's own)")
        ->check(CLI::Range(-1e6, 1e6))->multi_option_policy(last);
    app.add_option("--time", options.seconds, "seconds instead of a frame number")->check(CLI::Range(-1e6, 1e6))->excludes(frame)->multi_option_policy(last);
    app.add_option("--fps", options.framesPerSecond, "frames per second")->check(CLI::Range(0.1, 10000.0))->multi_option_policy(last);
    app.add_option("--shutter", options.shutterLength, "frames during which the shutter is open (0.5 is 180 degrees)")
        ->check(CLI::Range(0.0, 16.0))->multi_option_policy(last);
    app.add_option("--shutter-position", options.shutterPosition, "start, centre, end: where the frame's instant lies in the shutter")
        ->transform(CLI::CheckedTransformer(positions))->multi_option_policy(last);
    app.add_option("--seed", options.seed, "of all random numbers")->multi_option_policy(last);
    app.add_option("--context", options.context.kind, "auto, window, egl, osmesa")
        ->transform(CLI::CheckedTransformer(contexts))->multi_option_policy(last);
    app.add_option("--device", options.context.device, "number of an EGL device (list --devices)")
        ->check(CLI::Range(0, 1000))->multi_option_policy(last);
    app.add_option("--set", settings, "TECHNIQUE.KEY=VALUE, repeatable (list shows the keys)")->allow_extra_args(false);
    app.add_option("--camera", options.camera, "name of one of the scene's cameras")->multi_option_policy(last);
    app.add_option("--clip", options.clip, "name of one of the file's animations")->multi_option_policy(last);
    app.add_option("--view", options.view, "final, visibility")->transform(CLI::CheckedTransformer(views))->multi_option_policy(last);
    app.add_flag("--explain", options.explain, "print the plan: which passes run, and why");
    app.add_option("--json", options.json, "write a report of the frame")->multi_option_policy(last);
    app.add_flag("--gl-debug", options.debugGl, "fail on anything that the driver complains of");
    // Taken out beforehand; declared here for --help.
    app.add_option("--settings", "JSON file of these options; the command line wins");
}

/// Replaces `--settings F` by what the file says, right behind the command's name.
std::vector<std::string> withSettingsFile(std::vector<std::string> arguments) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const bool joined = arguments[i].rfind("--settings=", 0) == 0;
        if (!joined && (arguments[i] != "--settings" || i + 1 >= arguments.size())) continue;
        const std::string path = joined ? arguments[i].substr(11) : arguments[i + 1];
        arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i), arguments.begin() + static_cast<std::ptrdiff_t>(i + (joined ? 1 : 2)));
        const std::vector<std::string> more = argumentsOfFile(path);
        const bool startsWithCommand = !arguments.empty() && arguments.front().rfind("-", 0) != 0;
        arguments.insert(arguments.begin() + (startsWithCommand ? 1 : 0), more.begin(), more.end());
        break;
    }
    return arguments;
}

/// `timeshade` alone and `timeshade chess` mean the window.
void addDefaultCommand(std::vector<std::string>& arguments) {
    const std::vector<std::string> commands{"view", "shot", "pictures", "list"};
    const bool asks = !arguments.empty() && (arguments.front() == "--help" || arguments.front() == "-h" || arguments.front() == "--version");
    if (asks) return;
    const bool known = !arguments.empty() && std::find(commands.begin(), commands.end(), arguments.front()) != commands.end();
    if (!known) arguments.insert(arguments.begin(), "view");
}

std::string oneLine(std::string text) {
    const std::size_t end = text.find('\n');
    return end == std::string::npos ? text : text.substr(0, end);
}

} // namespace

Options parseCommandLine(int argumentCount, char** argumentValues) {
    Options options;
    std::string size;
    std::vector<std::string> settings;
    std::vector<std::string> arguments(argumentValues + 1, argumentValues + argumentCount);
    addDefaultCommand(arguments);
    arguments = withSettingsFile(std::move(arguments));

    CLI::App app("A real-time laboratory for motion-blurred shadows", "timeshade");
    app.set_version_flag("--version", "timeshade " TIMESHADE_VERSION);
    app.require_subcommand(1);
    app.option_defaults()->delimiter('\0');

    CLI::App* view = app.add_subcommand("view", "open the window");
    view->add_option("scene", options.scene, "a built-in scene or a .gltf or .glb file");
    addFrameOptions(*view, options, size, settings);

    CLI::App* shot = app.add_subcommand("shot", "draw a picture without a window");
    shot->add_option("scene", options.scene, "a built-in scene or a .gltf or .glb file")->required();
    shot->add_option("-o,--output", options.output, "F.png or F.exr")->required();
    shot->add_option("--frames", options.frames, "number of frames to draw, one file each (F.0000.png, ...)")->check(CLI::Range(1, 100000));
    addFrameOptions(*shot, options, size, settings);

    CLI::App* pictures = app.add_subcommand("pictures", "draw every built-in scene into a folder, with a table of times");
    pictures->add_option("-o,--output", options.output, "folder")->required();
    addFrameOptions(*pictures, options, size, settings);

    CLI::App* list = app.add_subcommand("list", "scenes, techniques and their settings");
    list->add_flag("--json", options.listAsJson, "as JSON");
    list->add_flag("--devices", options.listDevices, "the EGL devices of this machine");

    std::reverse(arguments.begin(), arguments.end());  // what CLI11 expects of a vector
    try {
        app.parse(arguments);
    } catch (const CLI::Success& success) {
        std::exit(app.exit(success));
    } catch (const CLI::ParseError& error) {
        throw UsageError(oneLine(error.what()) + " (timeshade --help)");
    }
    options.command = view->parsed() ? Command::View : shot->parsed() ? Command::Shot : pictures->parsed() ? Command::Pictures : Command::List;
    if (!size.empty()) parseSize(size, options);
    for (const std::string& setting : settings) parseSetting(setting, options);
    if (options.command == Command::Shot) {
        const std::string& path = options.output;
        const bool known = path.size() > 4 && (path.ends_with(".png") || path.ends_with(".exr"));
        if (!known) throw UsageError(fmt::format("-o {}: expected a name that ends in .png or .exr", path));
    }
    checkSettings(options);
    return options;
}

} // namespace timeshade
