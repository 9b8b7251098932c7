#include "options.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "frame_setup.h"
#include "scene/error.h"
#include "scene_catalogue.h"
#include "scenes/scene_recipe.h"
#include "techniques/registry.h"
#include "techniques/technique_views.h"

namespace timeshade {

namespace {

/// The value checks are our own: CLI11's ranges let NaN pass, its words may also be given as numbers, and the messages
/// of both leave out what was expected or say more than that.
template <typename T>
CLI::Validator numberFrom(T low, T high) {
    return CLI::Validator(
        [low, high](const std::string& text) {
            T number{};
            const auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
            const bool good = failure == std::errc{} && rest == text.data() + text.size() && number >= low && number <= high;
            return good ? std::string{}
                        : fmt::format("'{}' given, expected a {} from {} to {}", text,
                                      std::is_integral_v<T> ? "whole number" : "number", low, high);
        },
        fmt::format("{} to {}", low, high));
}

CLI::Validator notEmpty(const std::string& expected) {
    return CLI::Validator([expected](const std::string& text) { return text.empty() ? "'' given, expected " + expected : ""; }, "");
}

/// Replaces a word by its enumerator's number, which is how CLI11 reads enumerations.
template <typename Enum>
CLI::Validator oneOf(const std::vector<std::pair<std::string, Enum>>& words) {
    return CLI::Validator(
        [words](std::string& text) {
            std::string known;
            for (const auto& [word, value] : words) {
                if (word == text) {
                    text = std::to_string(static_cast<int>(value));
                    return std::string{};
                }
                known += (known.empty() ? "" : ", ") + word;
            }
            return fmt::format("'{}' given, expected one of {}", text, known);
        },
        "");
}

std::string scenesInWords() {
    std::string names;
    for (const BuiltInScene& scene : builtInScenes()) names += (names.empty() ? "" : ", ") + scene.name;
    return names + ", or a .gltf or .glb file";
}

std::string techniquesInWords() {
    std::string names;
    for (const TechniqueDescription& technique : techniqueDescriptions()) names += (names.empty() ? "" : ", ") + technique.name;
    return names;
}

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
        throw UsageError(fmt::format("--set {}: expected NAME.KEY=VALUE, as in tsm.bias=0.5 or cubes.count=2000", text));
    options.settings.emplace_back(text.substr(0, equals), text.substr(equals + 1));
}

/// "cubes.count=1000,2000". Every value is tried at once.
void parseVaried(const std::string& text, Options& options) {
    const std::string expected = "expected SCENE.KEY=V1,V2,... of a computed scene, as in cubes.count=1000,2000";
    const std::size_t equals = text.find('='), dot = text.find('.');
    if (equals == std::string::npos || dot == std::string::npos || dot > equals) throw UsageError(fmt::format("--vary {}: {}", text, expected));
    const std::string scene = text.substr(0, dot);
    const std::unique_ptr<SceneRecipe> recipe = makeRecipe(scene);
    if (!recipe) throw UsageError(fmt::format("--vary {}: '{}' is no computed scene; {}", text, scene, expected));
    options.variedSetting = text.substr(0, equals);
    std::istringstream values(text.substr(equals + 1));
    for (std::string value; std::getline(values, value, ',');) {
        setFromText(*recipe, text.substr(dot + 1, equals - dot - 1), value);
        options.variedValues.push_back(value);
    }
    if (options.variedValues.empty()) throw UsageError(fmt::format("--vary {}: {}", text, expected));
    if (options.measuredScenes.empty()) options.measuredScenes = {scene};
    if (std::find(options.measuredScenes.begin(), options.measuredScenes.end(), scene) == options.measuredScenes.end())
        throw UsageError(fmt::format("--vary {}: scene {} is not among those that are measured", text, scene));
}

std::unique_ptr<Technique> techniqueOfSetting(const std::string& name, gl::ProgramCache& programs) {
    std::string known;
    for (const TechniqueDescription& technique : techniqueDescriptions()) {
        if (technique.name == name) return makeTechnique(name, programs);
        known += technique.name + ", ";
    }
    for (const RecipeDescription& recipe : recipeDescriptions()) known += recipe.name + (&recipe == &recipeDescriptions().back() ? "" : ", ");
    throw UsageError(fmt::format("--set: '{}' is no technique and no computed scene; expected one of {}", name, known));
}

/// Settings are checked at once against what declares them, so that a typing error costs no rendering.
void checkSettings(const Options& options) {
    gl::ProgramCache programs;
    makeTechnique(options.technique, programs);
    for (const auto& [name, value] : options.settings) {
        const std::string owner = name.substr(0, name.find('.')), key = name.substr(owner.size() + 1);
        if (const std::unique_ptr<SceneRecipe> recipe = makeRecipe(owner))
            setFromText(*recipe, key, value);
        else
            setFromText(*techniqueOfSetting(owner, programs), key, value);
    }
}

/// A settings file is a JSON object: keys are the long options without their dashes, and "set" an object of technique
/// and scene settings. It is turned into arguments that come before those of the command line, which therefore win.
std::vector<std::string> argumentsOfFile(const std::string& path) {
    std::ifstream stream(path);
    std::ostringstream bytes;
    // A folder opens like a file and fails only when it is read.
    if (!stream || stream.peek() == std::ifstream::traits_type::eof() || !(bytes << stream.rdbuf()))
        throw Error(fmt::format("--settings '{}': cannot be read; expected a JSON file of settings", path));
    nlohmann::json json;
    try {
        json = nlohmann::json::parse(bytes.str());
    } catch (const nlohmann::json::exception&) {
        throw Error(fmt::format("{}: is not JSON; expected an object of settings", path));
    }
    if (!json.is_object()) throw Error(fmt::format("{}: holds a JSON {}; expected an object of settings", path, json.type_name()));
    const auto text = [](const nlohmann::json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); };
    std::vector<std::string> arguments;
    for (const auto& [key, value] : json.items()) {
        if (key == "set" && value.is_object()) {
            for (const auto& [name, setting] : value.items()) arguments.push_back("--set=" + name + "=" + text(setting));
        } else if (key == "settings" || key == "help") {
            throw Error(fmt::format("{}: \"{}\" is not a setting; expected options that say what to draw", path, key));
        } else if (value.is_primitive() && !value.is_null()) {
            // Joined, so that a switch's value is not taken for the scene, nor a negative number for an option. But
            // CLI11 goes on to the next argument where nothing follows the equals sign.
            arguments.push_back("--" + key + (text(value).empty() ? "" : "=" + text(value)));
            if (text(value).empty()) arguments.emplace_back();
        } else {
            throw Error(fmt::format("{}: \"{}\" is {}; expected a number, a string or a switch", path, key, value.type_name()));
        }
    }
    return arguments;
}

/// What --view says: one of the program's own views, or one of the technique's.
void chooseView(const std::string& name, Options& options) {
    if (name == "visibility") options.view = View::Visibility;
    if (name == "final" || name == "visibility") return;
    if (name == "error" || name == "disagreement") {
        if (options.command != Command::Shot || !options.output.ends_with(".png"))
            throw UsageError(fmt::format("--view {}: is for `shot` with a .png file; expected final or visibility here", name));
        options.diagnostic = name == "error" ? Diagnostic::Error : Diagnostic::Disagreement;
        return;
    }
    gl::ProgramCache programs;
    viewOf(*techniqueFor(options, programs), name);
    if (options.command == Command::Verify || options.command == Command::Measure)
        throw UsageError(fmt::format("--view {}: is for pictures; expected final or visibility here", name));
    options.techniqueView = name;
}

void addFrameOptions(CLI::App& app, Options& options, std::string& size, std::vector<std::string>& settings, std::string& viewName) {
    const auto last = CLI::MultiOptionPolicy::TakeLast;
    app.add_option("--technique", options.technique, techniquesInWords())->multi_option_policy(last);
    app.add_option("--spp", options.samplesPerPixel, "camera samples per pixel, one per stratum of the shutter")
        ->check(numberFrom(1, maximumSamplesPerPixel))->multi_option_policy(last);
    app.add_option("--size", size, "WIDTHxHEIGHT of the picture")->check(notEmpty("WIDTHxHEIGHT"))->multi_option_policy(last);
    app.add_option("--map", options.mapSize, "texels along a side of the light's map")
        ->check(numberFrom(minimumMapSize, maximumMapSize))->multi_option_policy(last);
    auto* frame = app.add_option("--frame", options.frame, "number of the frame (default: the scene's own)")
        ->check(numberFrom(-1e6, 1e6))->multi_option_policy(last);
    app.add_option("--time", options.seconds, "seconds instead of a frame number")->check(numberFrom(-1e6, 1e6))->excludes(frame)->multi_option_policy(last);
    app.add_option("--fps", options.framesPerSecond, "frames per second")->check(numberFrom(0.1, 10000.0))->multi_option_policy(last);
    app.add_option("--shutter", options.shutterLength, "frames during which the shutter is open (0.5 is 180 degrees)")
        ->check(numberFrom(0.0, 16.0))->multi_option_policy(last);
    app.add_option("--shutter-position", options.shutterPosition, "start, centre, end: where the frame's instant lies in the shutter")
        ->transform(oneOf<ShutterPosition>({{"start", ShutterPosition::Start}, {"centre", ShutterPosition::Centre},
                                            {"end", ShutterPosition::End}}))
        ->multi_option_policy(last);
    app.add_option("--seed", options.seed, "of all random numbers")->check(numberFrom(0u, 4294967295u))->multi_option_policy(last);
    app.add_option("--context", options.context.kind, "auto, window, egl, osmesa")
        ->transform(oneOf<ContextKind>({{"auto", ContextKind::Auto}, {"window", ContextKind::Window},
                                        {"egl", ContextKind::Egl}, {"osmesa", ContextKind::OsMesa}}))
        ->multi_option_policy(last);
    app.add_option("--device", options.context.device, "number of an EGL device (list --devices)")
        ->check(numberFrom(0, 1000))->multi_option_policy(last);
    app.add_option("--set", settings, "NAME.KEY=VALUE of a technique or a computed scene, as in tsm.bias=0.5 or cubes.count=2000, repeatable (list shows the keys)")->allow_extra_args(false);
    app.add_option("--camera", options.camera, "name of one of the scene's cameras")->check(notEmpty("a camera's name"))->multi_option_policy(last);
    app.add_option("--clip", options.clip, "name of one of the file's animations")->check(notEmpty("a clip's name"))->multi_option_policy(last);
    app.add_option("--view", viewName, "final, visibility, or one of the technique's own (list shows them); for shot also error (against a ray-traced reference) and disagreement")
        ->multi_option_policy(last);
    app.add_flag("--explain", options.explain, "print the plan: which passes run, and why");
    app.add_option("--json", options.json, "write a report of the frame")->check(notEmpty("a file name"))->multi_option_policy(last);
    app.add_flag("--gl-debug", options.debugGl, "fail on anything that the driver complains of, and on a NaN or an infinity in any buffer");
    // Taken out beforehand; declared here for --help.
    app.add_option("--settings", "JSON file of these options; the command line wins");
}

/// What the measurement of hard cases leaves open.
void addCaseOptions(CLI::App& app, Options& options, std::vector<std::string>& settings) {
    const auto last = CLI::MultiOptionPolicy::TakeLast;
    app.add_option("--spp", options.samplesPerPixel, "camera samples per pixel, one per stratum of the shutter")
        ->check(numberFrom(1, maximumSamplesPerPixel))->multi_option_policy(last);
    app.add_option("--map", options.mapSize, "texels along a side of the light's map (default: 512)")
        ->check(numberFrom(minimumMapSize, maximumMapSize))->multi_option_policy(last);
    app.add_option("--context", options.context.kind, "auto, window, egl, osmesa")
        ->transform(oneOf<ContextKind>({{"auto", ContextKind::Auto}, {"window", ContextKind::Window},
                                        {"egl", ContextKind::Egl}, {"osmesa", ContextKind::OsMesa}}))
        ->multi_option_policy(last);
    app.add_option("--device", options.context.device, "number of an EGL device (list --devices)")
        ->check(numberFrom(0, 1000))->multi_option_policy(last);
    app.add_option("--set", settings, "TECHNIQUE.KEY=VALUE, repeatable (list shows the keys)")->allow_extra_args(false);
    app.add_option("--json", options.json, "write the matrix as JSON; - prints it")->check(notEmpty("a file name"))->multi_option_policy(last);
    app.add_flag("--gl-debug", options.debugGl, "fail on anything that the driver complains of, and on a NaN or an infinity in any buffer");
}

/// Replaces every `--settings F` by what the file says, right behind the command's name; of two files the later wins.
std::vector<std::string> withSettingsFiles(const std::vector<std::string>& arguments) {
    std::vector<std::string> ofFiles, others;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const bool joined = arguments[i].rfind("--settings=", 0) == 0;
        if (!joined && (arguments[i] != "--settings" || i + 1 >= arguments.size())) {
            others.push_back(arguments[i]);
            continue;
        }
        const std::vector<std::string> more = argumentsOfFile(joined ? arguments[i].substr(11) : arguments[++i]);
        ofFiles.insert(ofFiles.end(), more.begin(), more.end());
    }
    const bool startsWithCommand = !others.empty() && others.front().rfind("-", 0) != 0;
    others.insert(others.begin() + (startsWithCommand ? 1 : 0), ofFiles.begin(), ofFiles.end());
    return others;
}

/// `timeshade` alone and `timeshade chess` mean the window.
void addDefaultCommand(std::vector<std::string>& arguments) {
    const std::vector<std::string> commands{"view", "shot", "pictures", "verify", "measure", "cases", "list"};
    const bool asks = !arguments.empty() && (arguments.front() == "--help" || arguments.front() == "-h" || arguments.front() == "--version");
    if (asks) return;
    const bool known = !arguments.empty() && std::find(commands.begin(), commands.end(), arguments.front()) != commands.end();
    if (!known) arguments.insert(arguments.begin(), "view");
}

} // namespace

Options parseCommandLine(int argumentCount, char** argumentValues) {
    Options options;
    std::string size;
    std::vector<std::string> settings;
    std::string viewName = "final", varied;
    std::vector<std::string> arguments(argumentValues + 1, argumentValues + argumentCount);
    options.commandLine = "timeshade";
    for (const std::string& argument : arguments) options.commandLine += " " + argument;
    addDefaultCommand(arguments);
    arguments = withSettingsFiles(arguments);

    CLI::App app("A real-time laboratory for motion-blurred shadows", "timeshade");
    app.set_version_flag("--version", "timeshade " TIMESHADE_VERSION);
    app.require_subcommand(1);
    app.option_defaults()->delimiter('\0');

    CLI::App* view = app.add_subcommand("view", "open the window");
    view->add_option("scene", options.scene, scenesInWords());
    addFrameOptions(*view, options, size, settings, viewName);

    CLI::App* shot = app.add_subcommand("shot", "draw a picture without a window");
    shot->add_option("scene", options.scene, scenesInWords())->required();
    shot->add_option("-o,--output", options.output, "F.png or F.exr")->required();
    shot->add_option("--frames", options.frames, "number of frames to draw, one file each (F.0000.png, ...)")->check(numberFrom(1, 100000));
    addFrameOptions(*shot, options, size, settings, viewName);

    CLI::App* pictures = app.add_subcommand("pictures", "draw every built-in scene into a folder, with a table of times");
    pictures->add_option("-o,--output", options.output, "folder")->required();
    addFrameOptions(*pictures, options, size, settings, viewName);

    CLI::App* verify = app.add_subcommand("verify", "compare every camera sample with the ray-traced truth");
    verify->add_option("scene", options.scene, scenesInWords())->required();
    verify->add_option("--dump", options.dump, "folder for the data itself: triangles.csv, light.csv, samples.csv");
    verify->add_option("--max-ppm", options.maxPpm, "exit with 3 if more samples in a million disagree")->check(CLI::Range(0.0, 1e6));
    addFrameOptions(*verify, options, size, settings, viewName);

    CLI::App* measure = app.add_subcommand("measure", "accuracy against time: tables and charts into a folder");
    measure->add_option("scenes", options.measuredScenes, "built-in scenes or files (default: all built-in ones)");
    measure->add_option("-o,--output", options.output, "folder; a sweep that was interrupted goes on there")->required();
    measure->add_option("--techniques", options.measuredTechniques, "names, with settings after colons as in tsm:bias=2, and embree for the ray-traced peer (default: all)")->delimiter(',');
    measure->add_option("--vary", varied, "SCENE.KEY=V1,V2,... of a computed scene: measure it at each of these values, as in cubes.count=1000,2000")
        ->multi_option_policy(CLI::MultiOptionPolicy::Throw);
    auto* spps = measure->add_option("--spps", options.measuredEfforts, "samples per pixel to measure, as in 1,2,4,8,16 (with --vary by default that of --spp alone)");
    spps->delimiter(',')->check(numberFrom(1, maximumSamplesPerPixel));
    measure->add_option("--maps", options.measuredMaps, "map sizes to measure, as in 256,512")
        ->delimiter(',')->check(numberFrom(minimumMapSize, maximumMapSize));
    measure->add_option("--history-frames", options.historyFrames,
                        "instead: how a still picture of `history` converges, as in 1,5,10,20,40,60 (with --shutter 0 --spp 1: hard shadows)")
        ->delimiter(',')->check(numberFrom(1, 10000));
    measure->add_option("--rounds", options.rounds, "how often each point is timed, interleaved, each with its own seed")->check(numberFrom(2, 1000));
    measure->add_option("--reference", options.referenceSamples, "samples per pixel of the reference")->check(numberFrom(1, 65536));
    addFrameOptions(*measure, options, size, settings, viewName);

    CLI::App* cases = app.add_subcommand("cases", "hard cases with exact answers: every technique's truth on each");
    cases->add_option("-o,--output", options.output, "F.png: the matrix as a picture");
    cases->add_option("--technique,--techniques", options.measuredTechniques, "names, as in static,tsm (default: all)")->delimiter(',');
    addCaseOptions(*cases, options, settings);

    CLI::App* list = app.add_subcommand("list", "scenes, techniques and their settings");
    list->add_flag("--json", options.listAsJson, "as JSON");
    list->add_flag("--devices", options.listDevices, "the EGL devices of this machine");

    if (!arguments.empty() && arguments.front() == "cases") options.mapSize = 512;
    std::reverse(arguments.begin(), arguments.end());  // what CLI11 expects of a vector
    try {
        app.parse(arguments);
    } catch (const CLI::Success& success) {
        std::exit(app.exit(success));
    } catch (const CLI::ParseError& error) {
        throw UsageError(std::string(error.what()) + " (timeshade --help)");
    }
    options.command = cases->parsed() ? Command::Cases : measure->parsed() ? Command::Measure : verify->parsed() ? Command::Verify : view->parsed() ? Command::View : shot->parsed() ? Command::Shot : pictures->parsed() ? Command::Pictures : Command::List;
    if (options.command == Command::Measure) {  // small enough to sweep on a software renderer
        options.width = 320;
        options.height = 240;
    }
    if (!size.empty()) parseSize(size, options);
    if (!varied.empty()) {
        parseVaried(varied, options);
        if (spps->count() == 0) options.measuredEfforts = {options.samplesPerPixel};
    }
    for (const std::string& setting : settings) parseSetting(setting, options);
    if (options.command == Command::Cases && !options.output.empty() && !options.output.ends_with(".png"))
        throw UsageError(fmt::format("-o {}: expected a name that ends in .png", options.output));
    if (options.command == Command::Shot) {
        const std::string& path = options.output;
        const bool known = path.size() > 4 && (path.ends_with(".png") || path.ends_with(".exr"));
        if (!known) throw UsageError(fmt::format("-o {}: expected a name that ends in .png or .exr", path));
    }
    checkSettings(options);
    chooseView(viewName, options);
    return options;
}

} // namespace timeshade
