#include "record/video_file.h"

#include <cassert>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"
#include "record/stop_signals.h"
#include "record/video_check.h"

namespace timeshade {

namespace {

const char* encoderOf(VideoCodec codec) {
    switch (codec) {
    case VideoCodec::H264: return "libx264";
    case VideoCodec::Hevc: return "libx265";
    case VideoCodec::Av1: return "libsvtav1";
    }
    return "";
}

std::vector<std::string> commandFor(const VideoFormat& format) {
    std::vector<std::string> command{"ffmpeg", "-hide_banner", "-nostdin", "-loglevel", "error", "-y"};
    const auto add = [&](std::initializer_list<std::string> words) { command.insert(command.end(), words); };
    add({"-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", fmt::format("{}x{}", format.width, format.height)});
    add({"-framerate", fmt::format("{}", format.framesPerSecond), "-i", "pipe:0"});
    if (format.container == VideoContainer::Gif) {
        // One palette for all frames, of their own colours.
        add({"-vf", "split[a][b];[a]palettegen[palette];[b][palette]paletteuse"});
    } else {
        // Said in the file and done alike, so that players undo what was done.
        add({"-vf", "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int", "-pix_fmt",
             "yuv420p"});
        add({"-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv"});
        add({"-c:v", encoderOf(*format.codec), "-crf", fmt::format("{}", format.quality)});
        if (format.codec == VideoCodec::Hevc) add({"-tag:v", "hvc1", "-x265-params", "log-level=error"});
    }
    // Nothing that differs from run to run; the index in front, so that a player can begin at once.
    add({"-fflags", "+bitexact", "-flags:v", "+bitexact"});
    if (format.container == VideoContainer::Mp4 || format.container == VideoContainer::Mov)
        add({"-movflags", "+faststart"});
    add({"-f", muxerOf(format.container), fmt::format("file:/proc/self/fd/{}", ChildProcess::handedDescriptor)});
    return command;
}

std::filesystem::path checkedPath(const std::filesystem::path& path, const VideoFormat& format) {
    if (format.container != VideoContainer::Gif && (format.width % 2 != 0 || format.height % 2 != 0))
        throw UsageError(
            fmt::format("--size {}x{}: expected an even width and height for a video", format.width, format.height));
    if (kindOfTarget(path) == TargetKind::Stream)
        throw Error(fmt::format("cannot write {}: is a device or a pipe; expected a file name", path.string()));
    return path;
}

}  // namespace

VideoFile::VideoFile(std::filesystem::path path, const VideoFormat& format)
    : path_(checkedPath(path, format)),
      framesPerSecond_(format.framesPerSecond),
      part_(path_),
      encoder_(commandFor(format), part_.descriptor()) {
    requireVideoCheck(part_.descriptor());
}

VideoFile::~VideoFile() { encoder_.kill(); }

void VideoFile::add(const DisplayImage& frame) {
    if (!encoder_.feed({reinterpret_cast<const char*>(frame.rgb.data()), frame.rgb.size()})) fail();
    ++frames_;
}

void VideoFile::finish() {
    assert(frames_ > 0);
    if (!encoder_.finish()) fail();
    // Its exit code alone is no proof: ffmpeg 5.1 ends with 0 after it could not write a file's index.
    try {
        requireFinishedVideo(part_.descriptor(), frames_, framesPerSecond_);
    } catch (const Error& error) {
        throw Error(
            fmt::format("cannot write {}: ffmpeg ended without an error, but {}", path_.string(), error.what()));
    }
    part_.renameOntoTarget();
}

void VideoFile::fail() {
    if (StopSignals::count() > 1) encoder_.kill();
    encoder_.finish();
    throw Error(fmt::format("cannot write {}: ffmpeg ended after {} frames with {}", path_.string(), frames_,
                            encoder_.lastWords()));
}

}  // namespace timeshade
