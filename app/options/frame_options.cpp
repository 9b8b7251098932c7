#include "options/frame_options.h"

#include <cstdio>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "core/error.h"
#include "options/light_options.h"
#include "options/number_list.h"
#include "options/option_checks.h"
#include "options_text.h"

namespace timeshade {

namespace {

void readSize(const std::string& text, FrameOptions& options) {
    int width = 0, height = 0;
    char rest = '\0';
    if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 1 || height < 1 ||
        width > maximumImageSide || height > maximumImageSide)
        throw UsageError(fmt::format("--size {}: expected WIDTHxHEIGHT, each from 1 to {}", text, maximumImageSide));
    options.width = width;
    options.height = height;
    options.sizeGiven = true;
}

/// "25", or "24000/1001" as broadcasters write it; the quotient is what CLI11 reads.
CLI::Validator frameRate() {
    static constexpr double least = 0.1, most = 10000.0;
    return CLI::Validator(
        [](std::string& text) {
            const std::size_t slash = text.find('/');
            const auto whole = numbersIn<int>(text.substr(0, slash), 1),
                       parts = slash == std::string::npos ? whole : numbersIn<int>(text.substr(slash + 1), 1);
            const auto plain = numbersIn<double>(text, 1);
            const bool quotient = slash != std::string::npos && whole && parts && parts->front() > 0;
            const double rate = quotient ? static_cast<double>(whole->front()) / parts->front()
                                : plain  ? plain->front()
                                         : 0.0;
            if (!(rate >= least && rate <= most))
                return fmt::format("'{}' given, expected a number from {} to {}, or a fraction as 24000/1001", text,
                                   least, most);
            text = fmt::format("{}", rate);
            return std::string{};
        },
        fmt::format("{} to {}, or as 24000/1001", least, most));
}

void declareSampling(CLI::App& app, FrameOptions& options) {
    app.option_defaults()->group("Sampling");
    declareSamples(app, options.samplesPerPixel);
    addChoice<CameraSamples>(
        app, "--samples", options.samples, {{"strata", CameraSamples::Strata}, {"intervals", CameraSamples::Intervals}},
        "strata: each camera sample has a time of its own; intervals: --spp is the number of positions a "
        "pixel, and what each sees is solved for the whole shutter");
    app.add_option(
           "--time-strata", options.timeStrata,
           "of interval samples: strata of the shutter, in each of which techniques that test instants test one")
        ->check(numberFrom(1, maximumSamplesPerPixel))
        ->capture_default_str()
        ->multi_option_policy(lastWins);
    app.add_option_function<std::string>(
           "--size", [&options](const std::string& text) { readSize(text, options); }, "WIDTHxHEIGHT of the picture")
        ->check(notEmpty("WIDTHxHEIGHT"))
        ->default_str(fmt::format("{}x{}", options.width, options.height))
        ->multi_option_policy(lastWins);
    app.add_flag("--pixel-centres", options.pixelCentres,
                 "camera samples lie at pixel centres instead of one random place of the pixel each; times stay");
    declareMapSize(app, options.mapSize, "shadow map size: texels along a side, or WIDTHxHEIGHT");
    app.add_option("--seed", options.seed, "of all random numbers")
        ->check(numberFrom(0u, 4294967295u))
        ->capture_default_str()
        ->multi_option_policy(lastWins);
}

void declareTime(CLI::App& app, FrameOptions& options) {
    app.option_defaults()->group("Time");
    auto* frame = app.add_option("--frame", options.frame, "number of the frame (default: the scene's own)")
                      ->check(numberFrom(-1e6, 1e6))
                      ->multi_option_policy(lastWins);
    app.add_option("--time", options.seconds, "seconds instead of a frame number")
        ->check(numberFrom(-1e6, 1e6))
        ->excludes(frame)
        ->multi_option_policy(lastWins);
    app.add_option("--fps", options.framesPerSecond, "frames per second (default: the scene's own)")
        ->transform(frameRate())
        ->multi_option_policy(lastWins);
    addChoice<Looping>(
        app, "--loop", options.looping, {{"auto", Looping::Auto}, {"on", Looping::On}, {"off", Looping::Off}},
        "auto, on, off: before its start and after its end a clip repeats (on) or its first and last pose "
        "are held (off); auto repeats one whose end joins its start");
    app.add_option("--clip", options.clip, "name of one of the file's animations")
        ->check(notEmpty("a clip's name"))
        ->multi_option_policy(lastWins);
}

void declareShutter(CLI::App& app, FrameOptions& options) {
    app.option_defaults()->group("Shutter");
    app.add_option("--shutter", options.shutterLength,
                   "frames during which the shutter is open (0.5 is 180 degrees; default: the scene's own)")
        ->check(numberFrom(0.0, 16.0))
        ->multi_option_policy(lastWins);
    addChoice<ShutterPosition>(
        app, "--shutter-position", options.shutterPosition,
        {{"start", ShutterPosition::Start}, {"centre", ShutterPosition::Centre}, {"end", ShutterPosition::End}},
        "start, centre, end: where the frame's instant lies in the shutter");
    addChoice<ShutterResponse>(
        app, "--shutter-response", options.shutterResponse,
        {{"box", ShutterResponse::Box}, {"tent", ShutterResponse::Tent}, {"gaussian", ShutterResponse::Gaussian}},
        "box, tent, gaussian: how much each instant of the shutter counts in the picture");
    app.add_option("--shutter-width", options.shutterWidth,
                   "of the Gaussian, which is cut at the shutter's ends: its standard deviation as a share of the "
                   "shutter (default: a sixth)")
        ->check(numberFrom(Shutter::leastWidth, Shutter::mostWidth))
        ->multi_option_policy(lastWins);
    addChoice<int>(
        app, "--motion-steps", options.motionSteps, {{"1", 1}, {"2", 2}, {"4", 4}, {"8", 8}, {"16", 16}, {"32", 32}},
        "1, 2, 4, 8, 16, 32: into how many pieces the shutter is cut, in each of which all motion is linear; "
        "what turns or bounces is drawn right with enough. Lowered to what divides --spp");
    app.add_option("--instant", options.instant,
                   "one instant of the shutter instead of all of it: 0 where it opens, 1 where it closes")
        ->check(numberFrom(0.0, 1.0))
        ->multi_option_policy(lastWins);
}

void declareCamera(CLI::App& app, FrameOptions& options) {
    app.option_defaults()->group("Camera");
    app.add_option("--camera", options.camera, "name of one of the scene's cameras")
        ->check(notEmpty("a camera's name"))
        ->multi_option_policy(lastWins);
    app.add_option_function<std::string>(
           "--pose", [&options](const std::string& text) { options.pose = poseFromText(text); },
           "a camera of one's own: 14 numbers, as the window's \"Copy command line\" writes them")
        ->multi_option_policy(lastWins);
}

/// The names that these two had before stay, without a word in the help.
void declareYardsticks(CLI::App& app, FrameOptions& options) {
    app.option_defaults()->group("Yardsticks");
    app.add_flag("--force-dynamic", options.forceDynamic,
                 "treat every triangle as dynamic, cull nothing for what the camera sees, cache nothing");
    app.add_flag("--no-plan", options.forceDynamic)->group("");
    app.add_flag("--no-cache", options.noCache, "reuse nothing from frame to frame: draw what is static anew");
    app.add_flag("--no-keep", options.noCache)->group("");
}

}  // namespace

void declareOptions(CLI::App& app, FrameOptions& options) {
    declareSampling(app, options);
    declareTime(app, options);
    declareShutter(app, options);
    declareCamera(app, options);
    declareLight(app, options);
    declareGround(app, options);
    declareLook(app, options);
    declareYardsticks(app, options);
}

}  // namespace timeshade
