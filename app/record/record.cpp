#include <cstdio>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "frame_setup.h"
#include "headless.h"
#include "headless_gl.h"
#include "measure/map_size_json.h"
#include "output_path.h"
#include "record/frame_progress.h"
#include "record/part_painter.h"
#include "record/picture_folder.h"
#include "record/script.h"
#include "record/stop_signals.h"
#include "record/video_file.h"
#include "report.h"
#include "scene_catalogue.h"
#include "standard_error.h"

namespace timeshade {

namespace {

/// A part whose scene is there and whose options have been tried on it.
struct ReadyPart {
    const ScriptPart* part = nullptr;
    std::shared_ptr<const Scene> scene;
    std::unique_ptr<PartPainter> painter;
};

/// Parts that follow each other in one scene share it.
std::vector<ReadyPart> readyParts(const std::vector<ScriptPart>& parts, FrameRenderer& renderer,
                                  const PictureText& text) {
    std::vector<ReadyPart> ready;
    for (const ScriptPart& part : parts) {
        const ScriptPart* last = ready.empty() ? nullptr : ready.back().part;
        const bool same = last != nullptr && last->drawn.scene == part.drawn.scene &&
                          choiceOf(last->drawn) == choiceOf(part.drawn) && last->drawn.settings == part.drawn.settings;
        std::shared_ptr<const Scene> scene =
            same ? ready.back().scene : openScene(part.drawn.scene, choiceOf(part.drawn), part.drawn.settings);
        if (!same)
            for (const std::string& note : scene->notes()) tellNote(note);
        auto painter = std::make_unique<PartPainter>(renderer, part, *scene, text);
        ready.push_back({&part, std::move(scene), std::move(painter)});
    }
    return ready;
}

/// `drawn` is the first part's; all are of its size.
std::unique_ptr<FrameSink> sinkFor(const RecordOptions& options, const FrameOptions& drawn, double framesPerSecond) {
    const std::optional<VideoContainer> container = containerOf(options.output);
    if (!container) return std::make_unique<PictureFolder>(options.output);
    VideoFormat format;
    format.container = *container;
    format.width = drawn.width;
    format.height = drawn.height;
    format.framesPerSecond = framesPerSecond;
    format.codec = codecIn(*container, options.codec);
    format.quality = options.quality;
    return std::make_unique<VideoFile>(options.output, format);
}

/// Draws until the end or until a stop signal. How many frames there are then.
int drawAll(std::vector<ReadyPart>& parts, FrameSink& sink, const FrameProgress& progress, const HeadlessGl& opengl) {
    int done = 0;
    for (ReadyPart& part : parts) {
        for (int i = 0; i < part.painter->frames(); ++i) {
            const std::optional<DisplayImage> frame = part.painter->next();
            if (!frame) return done;
            opengl.requireSilence();
            sink.add(*frame);
            progress.update(++done);
        }
        part.painter.reset();  // its techniques' memory is another's now
    }
    return done;
}

[[noreturn]] void failStopped(FrameSink& sink, int done, int total) {
    const char* signal = StopSignals::name();
    if (done == 0) throw Error(fmt::format("stopped by {} before the first of {} frames", signal, total));
    sink.finish();
    throw Error(fmt::format("stopped by {} after {} of {} frames; {} holds these", signal, done, total, sink.kept()));
}

std::string reportOf(const RecordOptions& options, const std::vector<ScriptPart>& parts,
                     const std::vector<ReadyPart>& ready, const std::vector<int>& frames, double framesPerSecond,
                     double seconds, const gl::DeviceInfo& device) {
    nlohmann::ordered_json json;
    json["timeshade"] = TIMESHADE_VERSION;
    json["command"] = options.commandLine;
    json["size"] = {parts.front().drawn.width, parts.front().drawn.height};
    json["fps"] = framesPerSecond;
    int total = 0;
    for (std::size_t i = 0; i < ready.size(); ++i) {
        const PictureOptions& drawn = parts[i].drawn;
        json["parts"].push_back({{"scene", drawn.scene},
                                 {"first", total},
                                 {"frames", frames[i]},
                                 {"step", parts[i].step},
                                 {"spp", drawn.samplesPerPixel},
                                 {"map", asJson(drawn.mapSize)}});
        if (drawn.compared.empty())
            json["parts"].back()["technique"] = drawn.technique;
        else
            json["parts"].back()["compare"] = drawn.compared;
        total += frames[i];
    }
    json["frames"] = total;
    json["seconds"] = seconds;
    json["gl"] = {{"vendor", device.vendor},
                  {"renderer", device.renderer},
                  {"version", device.version},
                  {"software", device.software}};
    return json.dump(2) + "\n";
}

}  // namespace

int runRecord(const RecordOptions& options) {
    const std::vector<ScriptPart> parts = partsOf(options);
    if (!options.json.empty()) requireWritable(options.json);
    const HeadlessGl opengl(options);
    FrameRenderer renderer;
    renderer.setChecked(options.debugGl);
    const PictureText text;
    std::vector<ReadyPart> ready = readyParts(parts, renderer, text);
    const StopSignals signals;  // until here there is no file to close, and a signal ends the program at once

    // One rate for all: that of the first part, unless the command line has another.
    const double framesPerSecond =
        parts.front().drawn.framesPerSecond.value_or(ready.front().scene->defaults().framesPerSecond);
    std::vector<int> frames;
    int total = 0;
    for (const ReadyPart& part : ready) total += frames.emplace_back(part.painter->frames());
    const std::unique_ptr<FrameSink> sink = sinkFor(options, parts.front().drawn, framesPerSecond);
    double seconds = 0.0;
    {
        const FrameProgress progress(total);
        const int done = drawAll(ready, *sink, progress, opengl);
        if (done < total) failStopped(*sink, done, total);
        sink->finish();
        seconds = progress.secondsSoFar();
    }
    fmt::print("{}  {} frames of {} x {} at {:g} per second, drawn in {}  {}\n", fullPath(sink->kept()), total,
               parts.front().drawn.width, parts.front().drawn.height, framesPerSecond, inClockWords(seconds),
               deviceLine(renderer.device()));
    if (!options.json.empty()) {
        const std::string report = reportOf(options, parts, ready, frames, framesPerSecond, seconds, renderer.device());
        writeFileAtomically(options.json, report);
    }
    return 0;
}

}  // namespace timeshade
