#include "options/record_options.h"

#include "core/data_folder.h"
#include "core/error.h"
#include "options/command_parts.h"
#include "record/video_container.h"

namespace timeshade {

namespace {

void declareVideo(CLI::App& record, RecordOptions& options) {
    record
        .add_option("-o,--output", options.output,
                    "F.mp4, .mov, .mkv, .webm or .gif, or a folder for 0000.png, 0001.png, ...")
        ->required();
    record.add_option("--frames", options.frames, "number of frames (default: one turn of the scene's motion)")
        ->check(numberFrom(1, 1000000));
    record.add_option("--codec", options.codec, "h264, hevc, av1 (default: h264, in .webm av1)")
        ->transform(
            oneOf<VideoCodec>({{"h264", VideoCodec::H264}, {"hevc", VideoCodec::Hevc}, {"av1", VideoCodec::Av1}}));
    record.add_option("--quality", options.quality, "0 to 51, less is better and larger (the encoder's CRF)")
        ->check(numberFrom(0, 51))
        ->capture_default_str();
}

}  // namespace

void addRecordCommand(CLI::App& app, Command& command) {
    CLI::App* record = app.add_subcommand("record", "draw a video or a sequence of pictures without a window");
    auto reading = std::make_shared<CommandReading<RecordOptions>>();
    RecordOptions& options = reading->options;
    CLI::Option* scene = declareScene(*record, options.scene);
    declareVideo(*record, options);
    auto* script =
        record
            ->add_option("--script", options.script,
                         "JSON file of parts with scenes, techniques, wipes and captions (assets/demo.json is one)")
            ->check(notEmpty("a file name"))
            ->excludes(scene);
    record
        ->add_flag_callback(
            "--demo", [&options] { options.script = (dataFolder() / "assets" / "demo.json").string(); },
            "the tour of scenes and techniques: assets/demo.json")
        ->excludes(script)
        ->excludes(scene);
    declareDrawing(*record, *reading);
    whenRead(*record, command, reading, [scene](CommandReading<RecordOptions>& read) {
        if (scene->count() == 0 && read.options.script.empty())
            throw UsageError("record: no scene given; expected one, or --script F.json, or --demo");
        if (const auto container = containerOf(read.options.output)) codecIn(*container, read.options.codec);
        checkDrawing(read, {.comparisons = true, .techniqueViews = true}, read.options.output);
    });
}

}  // namespace timeshade
