#include "options/measure_options.h"

#include <algorithm>
#include <sstream>

#include "core/error.h"
#include "measure/technique_variant.h"
#include "options/command_parts.h"
#include "scenes/scene_recipe.h"

namespace timeshade {

namespace {

/// "cubes.count=1000,2000". Every value is tried at once.
void readVaried(const std::string& text, MeasureOptions& options) {
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

/// What is measured, of each other: scenes, techniques, and their parameters. Returns --spps.
CLI::Option* declareSweep(CLI::App& measure, MeasureOptions& options) {
    measure.add_option("scenes", options.measuredScenes, "built-in scenes or files (default: all built-in ones)");
    measure.add_option("-o,--output", options.output, "folder; a sweep that was interrupted goes on there")->required();
    measure
        .add_option("--techniques", options.measuredTechniques,
                    "names, with settings after colons as in tsm:bias=2 or integral:samples=intervals, and embree for "
                    "the ray-traced baseline (default: all)")
        ->delimiter(',');
    measure
        .add_option_function<std::vector<std::string>>(
            "--maps",
            [&options](const std::vector<std::string>& texts) {
                options.measuredMaps.clear();
                for (const std::string& text : texts) options.measuredMaps.push_back(*MapSize::of(text));
            },
            "shadow map sizes to measure, as in 256,512x384")
        ->delimiter(',')
        ->check(mapSizeText());
    measure
        .add_option("--rounds", options.rounds, "how often each point is timed, interleaved, each with its own seed")
        ->check(numberFrom(2, 1000))
        ->capture_default_str();
    measure
        .add_option("--sequence", options.sequenceFrames,
                    "frames of a sequence to time in each round (default: one), with rows for caches that fill")
        ->check(numberFrom(1, 1000));
    measure.add_option("--reference", options.referenceSamples, "samples per pixel of the reference")
        ->check(numberFrom(1, 65536))
        ->capture_default_str();
    measure
        .add_option("--reference-rays", options.referenceRays,
                    "rays per pixel of the converged visibility that shadow errors are measured against (cached "
                    "between runs; 0: no shadow error)")
        ->check(CLI::Range(0, 1 << 20));
    return measure
        .add_option("--spps", options.measuredSampleCounts,
                    "samples per pixel to measure, as in 1,2,4,8,16 (with --vary by default that of --spp alone)")
        ->delimiter(',')
        ->check(numberFrom(1, maximumSamplesPerPixel));
}

/// Measurements other than the sweep.
void declareOthers(CLI::App& measure, MeasureOptions& options) {
    measure
        .add_option("--convergence", options.convergenceFrames,
                    "instead: how a still picture converges with each of --techniques (default: all that converge), "
                    "after so many frames, as in 1,5,10,20,40,60 (with --shutter 0 --spp 1: hard shadows)")
        ->delimiter(',')
        ->check(numberFrom(1, 10000));
    // Its name in earlier versions.
    measure.add_option("--history-frames", options.convergenceFrames)
        ->delimiter(',')
        ->check(numberFrom(1, 10000))
        ->group("");
    measure.add_flag("--effects", options.effects,
                     "instead: what each thing that moves costs, and what the plan saves, for the first of "
                     "--techniques, with the others beside it (default: --technique alone)");
    measure.add_flag("--times", options.times,
                     "instead: what frames of --techniques take, on the device and on the processor, without any "
                     "errors");
    measure
        .add_option("--equal-time", options.equalTime,
                    "A,B,... instead: with how many samples per pixel B, ... take as long as A does with --spp, and "
                    "with which of --maps where several are given; pictures side by side")
        ->delimiter(',')
        ->allow_extra_args(false);
    measure
        .add_option("--equal-error", options.equalError,
                    "A,B,... instead: with how few samples per pixel B, ... have at most the shadow error that A has "
                    "with --spp")
        ->delimiter(',')
        ->allow_extra_args(false);
}

/// Completes and checks what --equal-time or --equal-error says.
void checkEqual(const CLI::App& measure, MeasureOptions& options) {
    if (options.equalTime.empty() && options.equalError.empty()) return;
    if (!options.equalTime.empty() && !options.equalError.empty())
        throw UsageError("--equal-time, --equal-error: both given, expected one of them");
    const std::string name = options.equalTime.empty() ? "--equal-error" : "--equal-time";
    const std::vector<std::string>& variants = options.equalTime.empty() ? options.equalError : options.equalTime;
    for (const char* other :
         {"--vary", "--effects", "--times", "--convergence", "--history-frames", "--techniques", "--spps"})
        if (measure.get_option(other)->count() > 0)
            throw UsageError(fmt::format("{}: {} given as well, expected one of them", name, other));
    if (variants.size() < 2)
        throw UsageError(
            fmt::format("{} {}: expected two techniques or more, as in tsm,ranges", name, variants.front()));
    if (options.referenceRays == 0)
        throw UsageError(fmt::format("--reference-rays 0: {} needs shadow errors, expected 1 or more", name));
    gl::ProgramCache programs;
    for (const std::string& variant : variants)
        TechniqueVariant::onItsSamples(variant).make(options.settings, programs);
    // The first has --map, the others --maps; where one of the two is given alone, it is for all.
    const bool map = measure.get_option("--map")->count() > 0, maps = measure.get_option("--maps")->count() > 0;
    if (map && !maps) options.measuredMaps = {options.mapSize};
    if (!map) options.mapSize = options.measuredMaps.front();
}

}  // namespace

void addMeasureCommand(CLI::App& app, Command& command) {
    CLI::App* measure = app.add_subcommand("measure", "accuracy against time: tables and charts into a folder");
    auto reading = std::make_shared<CommandReading<MeasureOptions>>();
    CLI::Option* sampleCounts = declareSweep(*measure, reading->options);
    auto varied = std::make_shared<std::string>();
    measure
        ->add_option("--vary", *varied,
                     "SCENE.KEY=V1,V2,... of a computed scene: measure it at each of these values, as in "
                     "cubes.count=1000,2000")
        ->multi_option_policy(CLI::MultiOptionPolicy::Throw);
    declareOthers(*measure, reading->options);
    declareDrawing(*measure, *reading);
    whenRead(*measure, command, reading, [measure, sampleCounts, varied](CommandReading<MeasureOptions>& read) {
        MeasureOptions& options = read.options;
        if (!varied->empty()) {
            readVaried(*varied, options);
            if (sampleCounts->count() == 0) options.measuredSampleCounts = {options.samplesPerPixel};
        }
        checkDrawing(read, {}, "");
        checkEqual(*measure, options);
    });
}

}  // namespace timeshade
