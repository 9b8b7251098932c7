#include "options.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <timeshade/paths.h>
#include <CLI/CLI.hpp>

#include "core/error.h"
#include "frame_setup.h"
#include "measure/technique_variant.h"
#include "options_text.h"
#include "scene_catalogue.h"
#include "scenes/scene_recipe.h"
#include "settings_file.h"
#include "technique/technique_views.h"
#include "techniques/registry.h"

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
            const bool good =
                failure == std::errc{} && rest == text.data() + text.size() && number >= low && number <= high;
            return good ? std::string{}
                        : fmt::format("'{}' given, expected a {} from {} to {}", text,
                                      std::is_integral_v<T> ? "whole number" : "number", low, high);
        },
        fmt::format("{} to {}", low, high));
}

CLI::Validator notEmpty(const std::string& expected) {
    return CLI::Validator(
        [expected](const std::string& text) { return text.empty() ? "'' given, expected " + expected : ""; }, "");
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
    for (const TechniqueDescription& technique : techniqueDescriptions())
        names += (names.empty() ? "" : ", ") + technique.name;
    return names;
}

void parseSize(const std::string& text, Options& options) {
    int width = 0, height = 0;
    char rest = '\0';
    if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 1 || height < 1 ||
        width > maximumImageSide || height > maximumImageSide)
        throw UsageError(fmt::format("--size {}: expected WIDTHxHEIGHT, each from 1 to {}", text, maximumImageSide));
    options.width = width;
    options.height = height;
}

void parseSetting(const std::string& text, Options& options) {
    const std::size_t equals = text.find('=');
    const std::size_t dot = text.find('.');
    if (equals == std::string::npos || dot == std::string::npos || dot > equals || dot == 0)
        throw UsageError(
            fmt::format("--set {}: expected NAME.KEY=VALUE, as in tsm.bias=0.5 or cubes.count=2000", text));
    options.settings.emplace_back(text.substr(0, equals), text.substr(equals + 1));
}

/// "cubes.count=1000,2000". Every value is tried at once.
void parseVaried(const std::string& text, Options& options) {
    const std::string expected = "expected SCENE.KEY=V1,V2,... of a computed scene, as in cubes.count=1000,2000";
    const std::size_t equals = text.find('='), dot = text.find('.');
    if (equals == std::string::npos || dot == std::string::npos || dot > equals)
        throw UsageError(fmt::format("--vary {}: {}", text, expected));
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
    for (const RecipeDescription& recipe : recipeDescriptions())
        known += recipe.name + (&recipe == &recipeDescriptions().back() ? "" : ", ");
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

void checkCompared(const Options& options) {
    gl::ProgramCache programs;
    for (const std::string& variant : options.compared) TechniqueVariant::of(variant).make(options.settings, programs);
    if (options.compared.empty()) return;
    if (options.command != Command::View && options.command != Command::Shot && options.command != Command::Record)
        throw UsageError("--compare: is for pictures; expected view, shot or record");
    if (options.output.ends_with(".exr"))
        throw UsageError(
            fmt::format("-o {}: a comparison has labels; expected a name that ends in .png", options.output));
}

/// What --view says: one of the program's own views, or one of the technique's.
void chooseView(const std::string& name, Options& options) {
    if (name == "visibility") options.view = View::Visibility;
    if (name == "final" || name == "visibility") return;
    if (name == "error" || name == "disagreement") {
        const bool shown =
            options.command == Command::View || (options.command == Command::Shot && options.output.ends_with(".png"));
        if (!shown)
            throw UsageError(fmt::format(
                "--view {}: is for the window and for `shot` with a .png file; expected final or visibility here",
                name));
        options.diagnostic = name == "error" ? Diagnostic::Error : Diagnostic::Disagreement;
        return;
    }
    gl::ProgramCache programs;
    viewOf(*techniqueFor(options, programs), name);
    if (options.command == Command::Verify || options.command == Command::Measure)
        throw UsageError(fmt::format("--view {}: is for pictures; expected final or visibility here", name));
    options.techniqueView = name;
}

void addFrameOptions(CLI::App& app, Options& options, std::string& size, std::vector<std::string>& settings,
                     std::string& viewName) {
    const auto last = CLI::MultiOptionPolicy::TakeLast;
    app.add_option("--technique", options.technique, techniquesInWords())->multi_option_policy(last);
    app.add_option("--spp", options.samplesPerPixel, "camera samples per pixel, one per stratum of the shutter")
        ->check(numberFrom(1, maximumSamplesPerPixel))
        ->multi_option_policy(last);
    app.add_option("--size", size, "WIDTHxHEIGHT of the picture")
        ->check(notEmpty("WIDTHxHEIGHT"))
        ->multi_option_policy(last);
    app.add_option("--map", options.mapSize, "texels along a side of the light's map")
        ->check(numberFrom(minimumMapSize, maximumMapSize))
        ->multi_option_policy(last);
    auto* frame = app.add_option("--frame", options.frame, "number of the frame (default: the scene's own)")
                      ->check(numberFrom(-1e6, 1e6))
                      ->multi_option_policy(last);
    app.add_option("--time", options.seconds, "seconds instead of a frame number")
        ->check(numberFrom(-1e6, 1e6))
        ->excludes(frame)
        ->multi_option_policy(last);
    app.add_option("--fps", options.framesPerSecond, "frames per second")
        ->check(numberFrom(0.1, 10000.0))
        ->multi_option_policy(last);
    app.add_option("--shutter", options.shutterLength, "frames during which the shutter is open (0.5 is 180 degrees)")
        ->check(numberFrom(0.0, 16.0))
        ->multi_option_policy(last);
    app.add_option("--shutter-position", options.shutterPosition,
                   "start, centre, end: where the frame's instant lies in the shutter")
        ->transform(oneOf<ShutterPosition>(
            {{"start", ShutterPosition::Start}, {"centre", ShutterPosition::Centre}, {"end", ShutterPosition::End}}))
        ->multi_option_policy(last);
    app.add_option("--instant", options.instant,
                   "one instant of the shutter instead of all of it: 0 where it opens, 1 where it closes")
        ->check(numberFrom(0.0, 1.0))
        ->multi_option_policy(last);
    app.add_option("--seed", options.seed, "of all random numbers")
        ->check(numberFrom(0u, 4294967295u))
        ->multi_option_policy(last);
    app.add_option("--context", options.context.kind, "auto, window, egl, osmesa")
        ->transform(oneOf<ContextKind>({{"auto", ContextKind::Auto},
                                        {"window", ContextKind::Window},
                                        {"egl", ContextKind::Egl},
                                        {"osmesa", ContextKind::OsMesa}}))
        ->multi_option_policy(last);
    app.add_option("--device", options.context.device, "number of an EGL device (list --devices)")
        ->check(numberFrom(0, 1000))
        ->multi_option_policy(last);
    app.add_option("--set", settings,
                   "NAME.KEY=VALUE of a technique or a computed scene, as in tsm.bias=0.5 or cubes.count=2000, "
                   "repeatable (list shows the keys)")
        ->allow_extra_args(false);
    app.add_option("--camera", options.camera, "name of one of the scene's cameras")
        ->check(notEmpty("a camera's name"))
        ->multi_option_policy(last);
    app.add_option_function<std::string>(
           "--pose", [&options](const std::string& text) { options.pose = poseFromText(text); },
           "a camera of one's own: 14 numbers, as the window's \"Copy command line\" writes them")
        ->multi_option_policy(last);
    app.add_option("--clip", options.clip, "name of one of the file's animations")
        ->check(notEmpty("a clip's name"))
        ->multi_option_policy(last);
    app.add_option("--view", viewName,
                   "final, visibility, or one of the technique's own (list shows them); for shot also error (against a "
                   "ray-traced reference) and disagreement")
        ->multi_option_policy(last);
    app.add_option("--compare", options.compared,
                   "A,B: two techniques in one picture, with settings after colons as in tsm:bias=2,ranges")
        ->delimiter(',')
        ->expected(2)
        ->multi_option_policy(CLI::MultiOptionPolicy::Throw);
    app.add_option("--compare-mode", options.compareMode, "wipe, side, difference")
        ->transform(oneOf<CompareMode>(
            {{"wipe", CompareMode::Wipe}, {"side", CompareMode::Side}, {"difference", CompareMode::Difference}}))
        ->multi_option_policy(last);
    app.add_option("--seam", options.seam, "where a wipe's seam lies: the share of the width that is the first's")
        ->check(numberFrom(0.0, 1.0))
        ->multi_option_policy(last);
    app.add_flag("--explain", options.explain, "print the plan: which passes run, and why");
    app.add_flag(
        "--no-plan", options.forceDynamic,
        "treat every triangle as moving, leave none out for what nobody sees, keep nothing from frame to frame");
    app.add_flag("--no-keep", options.noCache, "draw what stands still anew in every frame");
    app.add_option("--json", options.json, "write a report of the frame")
        ->check(notEmpty("a file name"))
        ->multi_option_policy(last);
    app.add_flag("--gl-debug", options.debugGl,
                 "fail on anything that the driver complains of, and on a NaN or an infinity in any buffer");
    // Taken out beforehand; declared here for --help.
    app.add_option("--settings", "JSON file of these options; the command line wins");
}

/// What the measurement of hard cases leaves open.
void addCaseOptions(CLI::App& app, Options& options, std::vector<std::string>& settings) {
    const auto last = CLI::MultiOptionPolicy::TakeLast;
    app.add_option("--spp", options.samplesPerPixel, "camera samples per pixel, one per stratum of the shutter")
        ->check(numberFrom(1, maximumSamplesPerPixel))
        ->multi_option_policy(last);
    app.add_option("--map", options.mapSize, "texels along a side of the light's map (default: 512)")
        ->check(numberFrom(minimumMapSize, maximumMapSize))
        ->multi_option_policy(last);
    app.add_option("--context", options.context.kind, "auto, window, egl, osmesa")
        ->transform(oneOf<ContextKind>({{"auto", ContextKind::Auto},
                                        {"window", ContextKind::Window},
                                        {"egl", ContextKind::Egl},
                                        {"osmesa", ContextKind::OsMesa}}))
        ->multi_option_policy(last);
    app.add_option("--device", options.context.device, "number of an EGL device (list --devices)")
        ->check(numberFrom(0, 1000))
        ->multi_option_policy(last);
    app.add_option("--set", settings, "TECHNIQUE.KEY=VALUE, repeatable (list shows the keys)")->allow_extra_args(false);
    app.add_option("--json", options.json, "write the matrix as JSON; - prints it")
        ->check(notEmpty("a file name"))
        ->multi_option_policy(last);
    app.add_flag("--gl-debug", options.debugGl,
                 "fail on anything that the driver complains of, and on a NaN or an infinity in any buffer");
}

/// Takes every `--settings F` out of the arguments. What the files say, in order.
std::vector<FileSetting> takeSettingsFiles(std::vector<std::string>& arguments) {
    std::vector<FileSetting> ofFiles;
    std::vector<std::string> others;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const bool joined = arguments[i].rfind("--settings=", 0) == 0;
        if (!joined && (arguments[i] != "--settings" || i + 1 >= arguments.size())) {
            others.push_back(arguments[i]);
            continue;
        }
        const std::vector<FileSetting> more = readSettingsFile(joined ? arguments[i].substr(11) : arguments[++i]);
        ofFiles.insert(ofFiles.end(), more.begin(), more.end());
    }
    arguments = std::move(others);
    return ofFiles;
}

/// The arguments with the first `count` settings right behind the command's name, so that the command line wins, and of
/// two files the later.
std::vector<std::string> withSettings(const std::vector<std::string>& arguments,
                                      const std::vector<FileSetting>& settings, std::size_t count) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < count; ++i)
        all.insert(all.end(), settings[i].arguments.begin(), settings[i].arguments.end());
    std::vector<std::string> whole = arguments;
    whole.insert(whole.begin() + 1, all.begin(), all.end());
    return whole;
}

/// `timeshade` alone and `timeshade chess` mean the window.
void addDefaultCommand(std::vector<std::string>& arguments) {
    const std::vector<std::string> commands{"view", "shot", "record", "pictures", "verify", "measure", "cases", "list"};
    const bool asks = !arguments.empty() &&
                      (arguments.front() == "--help" || arguments.front() == "-h" || arguments.front() == "--version");
    if (asks) return;
    const bool known =
        !arguments.empty() && std::find(commands.begin(), commands.end(), arguments.front()) != commands.end();
    if (!known) arguments.insert(arguments.begin(), "view");
}

}  // namespace

Options parseArguments(const std::vector<std::string>& given) {
    Options options;
    options.arguments = given;
    std::vector<std::string> arguments = given;
    std::string size;
    std::vector<std::string> settings;
    std::string viewName = "final", varied;

    CLI::App app("A real-time laboratory for motion-blurred shadows", "timeshade");
    app.set_version_flag("--version", "timeshade " TIMESHADE_VERSION);
    app.require_subcommand(1);
    app.option_defaults()->delimiter('\0');

    CLI::App* view = app.add_subcommand("view", "open the window");
    view->add_option("scene,--scene", options.scene, scenesInWords())
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    addFrameOptions(*view, options, size, settings, viewName);

    CLI::App* shot = app.add_subcommand("shot", "draw a picture without a window");
    shot->add_option("scene,--scene", options.scene, scenesInWords())
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
        ->required();
    shot->add_option("-o,--output", options.output, "F.png or F.exr")->required();
    shot->add_option("--frames", options.frames, "number of frames to draw, one file each (F.0000.png, ...)")
        ->check(numberFrom(1, 100000));
    addFrameOptions(*shot, options, size, settings, viewName);

    CLI::App* record = app.add_subcommand("record", "draw a video or a sequence of pictures without a window");
    auto* recordedScene = record->add_option("scene,--scene", options.scene, scenesInWords())
                              ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    record->add_option("-o,--output", options.output, "F.mp4, or a folder for 0000.png, 0001.png, ...")->required();
    record->add_option("--frames", options.frames, "number of frames (default: one turn of the scene's motion)")
        ->check(numberFrom(1, 1000000));
    record->add_option("--codec", options.codec, "h264, hevc, av1")
        ->transform(
            oneOf<VideoCodec>({{"h264", VideoCodec::H264}, {"hevc", VideoCodec::Hevc}, {"av1", VideoCodec::Av1}}));
    record->add_option("--quality", options.quality, "0 to 51, less is better and larger (the encoder's CRF)")
        ->check(numberFrom(0, 51));
    auto* script =
        record
            ->add_option("--script", options.script,
                         "JSON file of parts with scenes, techniques, wipes and captions (assets/demo.json is one)")
            ->check(notEmpty("a file name"))
            ->excludes(recordedScene);
    bool demo = false;
    record->add_flag("--demo", demo, "the tour of scenes and techniques: assets/demo.json")
        ->excludes(script)
        ->excludes(recordedScene);
    addFrameOptions(*record, options, size, settings, viewName);

    CLI::App* pictures =
        app.add_subcommand("pictures", "draw every built-in scene into a folder, with a table of times");
    pictures->add_option("-o,--output", options.output, "folder")->required();
    addFrameOptions(*pictures, options, size, settings, viewName);

    CLI::App* verify = app.add_subcommand("verify", "compare every camera sample with the ray-traced truth");
    verify->add_option("scene,--scene", options.scene, scenesInWords())
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
        ->required();
    verify->add_option("--dump", options.dump, "folder for the data itself: triangles.csv, light.csv, samples.csv");
    verify
        ->add_option("--max-ppm", options.maxPpm,
                     "exit with 3 if more samples in a million disagree; for techniques that look at an instant at a "
                     "point")
        ->check(CLI::Range(0.0, 1e6));
    verify
        ->add_option("--reference-rays", options.referenceRays,
                     "rays a pixel of the converged visibility that shadow errors are measured against (default: 1024, "
                     "kept between runs; 0: no shadow error)")
        ->check(CLI::Range(0, 1 << 20));
    addFrameOptions(*verify, options, size, settings, viewName);

    CLI::App* measure = app.add_subcommand("measure", "accuracy against time: tables and charts into a folder");
    measure->add_option("scenes", options.measuredScenes, "built-in scenes or files (default: all built-in ones)");
    measure->add_option("-o,--output", options.output, "folder; a sweep that was interrupted goes on there")
        ->required();
    measure
        ->add_option(
            "--techniques", options.measuredTechniques,
            "names, with settings after colons as in tsm:bias=2, and embree for the ray-traced peer (default: all)")
        ->delimiter(',');
    measure
        ->add_option(
            "--vary", varied,
            "SCENE.KEY=V1,V2,... of a computed scene: measure it at each of these values, as in cubes.count=1000,2000")
        ->multi_option_policy(CLI::MultiOptionPolicy::Throw);
    auto* spps = measure->add_option(
        "--spps", options.measuredSampleCounts,
        "samples per pixel to measure, as in 1,2,4,8,16 (with --vary by default that of --spp alone)");
    spps->delimiter(',')->check(numberFrom(1, maximumSamplesPerPixel));
    measure->add_option("--maps", options.measuredMaps, "map sizes to measure, as in 256,512")
        ->delimiter(',')
        ->check(numberFrom(minimumMapSize, maximumMapSize));
    measure
        ->add_option("--history-frames", options.historyFrames,
                     "instead: how a still picture of `history` converges, as in 1,5,10,20,40,60 (with --shutter 0 "
                     "--spp 1: hard shadows)")
        ->delimiter(',')
        ->check(numberFrom(1, 10000));
    measure->add_flag("--effects", options.effects,
                      "instead: what each thing that moves costs, and what the plan saves, for the first of "
                      "--techniques (default: ranges)");
    measure
        ->add_option("--rounds", options.rounds, "how often each point is timed, interleaved, each with its own seed")
        ->check(numberFrom(2, 1000));
    measure->add_option("--reference", options.referenceSamples, "samples per pixel of the reference")
        ->check(numberFrom(1, 65536));
    addFrameOptions(*measure, options, size, settings, viewName);

    CLI::App* cases = app.add_subcommand("cases", "hard cases with exact answers: every technique's truth on each");
    cases->add_option("-o,--output", options.output, "F.png: the matrix as a picture");
    cases->add_option("--technique,--techniques", options.measuredTechniques, "names, as in static,tsm (default: all)")
        ->delimiter(',');
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
    options.command = cases->parsed()      ? Command::Cases
                      : measure->parsed()  ? Command::Measure
                      : verify->parsed()   ? Command::Verify
                      : view->parsed()     ? Command::View
                      : shot->parsed()     ? Command::Shot
                      : record->parsed()   ? Command::Record
                      : pictures->parsed() ? Command::Pictures
                                           : Command::List;
    if (options.command == Command::Measure) {  // small enough to sweep on a software renderer
        options.width = 320;
        options.height = 240;
    }
    if (!size.empty()) parseSize(size, options);
    if (!varied.empty()) {
        parseVaried(varied, options);
        if (spps->count() == 0) options.measuredSampleCounts = {options.samplesPerPixel};
    }
    for (const std::string& setting : settings) parseSetting(setting, options);
    if (options.command == Command::Cases && !options.output.empty() && !options.output.ends_with(".png"))
        throw UsageError(fmt::format("-o {}: expected a name that ends in .png", options.output));
    if (options.command == Command::Shot) {
        const std::string& path = options.output;
        const bool known = path.size() > 4 && (path.ends_with(".png") || path.ends_with(".exr"));
        if (!known) throw UsageError(fmt::format("-o {}: expected a name that ends in .png or .exr", path));
    }
    if (options.command == Command::Record) {
        if (demo) options.script = TIMESHADE_SOURCE_DIRECTORY "/assets/demo.json";
        if (recordedScene->count() == 0 && options.script.empty())
            throw UsageError("record: no scene given; expected one, or --script F.json, or --demo");
    }
    checkSettings(options);
    checkCompared(options);
    chooseView(viewName, options);
    return options;
}

Options parseWithSettings(const std::vector<std::string>& arguments, const std::vector<FileSetting>& settings) {
    try {
        return parseArguments(withSettings(arguments, settings, settings.size()));
    } catch (const UsageError& error) {
        // The first setting without which all was well is named with its place.
        std::size_t good = 0;
        for (; good < settings.size(); ++good) {
            try {
                parseArguments(withSettings(arguments, settings, good));
            } catch (const UsageError&) {
                break;
            }
        }
        if (good == 0) throw;
        throw UsageError(fmt::format("{}: {}", settings[good - 1].place, error.what()));
    }
}

Options parseCommandLine(int argumentCount, char** argumentValues) {
    std::vector<std::string> arguments(argumentValues + 1, argumentValues + argumentCount);
    std::string typed = "timeshade";
    for (const std::string& argument : arguments) typed += " " + argument;
    addDefaultCommand(arguments);
    const std::vector<FileSetting> ofFiles = takeSettingsFiles(arguments);
    Options options = parseWithSettings(arguments, ofFiles);
    options.commandLine = typed;
    return options;
}

}  // namespace timeshade
