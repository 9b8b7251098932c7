#include "record/video_file.h"

#include <cassert>
#include <cerrno>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "record/stop_signals.h"

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

std::vector<std::string> commandFor(const VideoFormat& format, const std::filesystem::path& part) {
    std::vector<std::string> command{"ffmpeg", "-hide_banner", "-nostdin", "-loglevel", "error", "-y"};
    const auto add = [&](std::initializer_list<std::string> words) { command.insert(command.end(), words); };
    add({"-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", fmt::format("{}x{}", format.width, format.height)});
    add({"-framerate", fmt::format("{}", format.framesPerSecond), "-i", "pipe:0"});
    // Said in the file and done alike, so that players undo what was done.
    add({"-vf", "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int", "-pix_fmt", "yuv420p"});
    add({"-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv"});
    add({"-c:v", encoderOf(format.codec), "-crf", fmt::format("{}", format.quality)});
    if (format.codec == VideoCodec::Hevc) add({"-tag:v", "hvc1", "-x265-params", "log-level=error"});
    // Nothing that differs from run to run; the index in front, so that a player can begin at once.
    add({"-fflags", "+bitexact", "-flags:v", "+bitexact", "-movflags", "+faststart", "-f", "mp4",
         "file:" + part.string()});
    return command;
}

/// Where the links of the path end, and that a file can be made there.
std::filesystem::path checkedTarget(const std::filesystem::path& path, const VideoFormat& format) {
    if (format.width % 2 != 0 || format.height % 2 != 0)
        throw UsageError(
            fmt::format("--size {}x{}: expected an even width and height for a video", format.width, format.height));
    requireWritable(path);
    std::error_code failure;
    const std::filesystem::path target = std::filesystem::weakly_canonical(path, failure);
    if (std::filesystem::exists(path, failure) && !std::filesystem::is_regular_file(path, failure))
        throw Error(fmt::format("cannot write {}: is a device or a pipe; expected a file name", path.string()));
    return target;
}

std::filesystem::path partOf(const std::filesystem::path& target) {
    return target.parent_path() / fmt::format("{}.{}.part", target.filename().string().substr(0, 200), ::getpid());
}

}  // namespace

VideoFile::VideoFile(std::filesystem::path path, const VideoFormat& format)
    : path_(std::move(path)), part_(partOf(checkedTarget(path_, format))), encoder_(commandFor(format, part_)) {}

VideoFile::~VideoFile() {
    encoder_.kill();
    ::unlink(part_.c_str());
}

void VideoFile::add(const DisplayImage& frame) {
    if (!encoder_.feed({reinterpret_cast<const char*>(frame.rgb.data()), frame.rgb.size()})) fail();
    ++frames_;
}

void VideoFile::finish() {
    assert(frames_ > 0);
    if (!encoder_.finish()) fail();
    const std::filesystem::path target = std::filesystem::weakly_canonical(path_);
    const int file = ::open(part_.c_str(), O_RDONLY | O_CLOEXEC);
    int failure = file < 0 || ::fsync(file) != 0 ? errno : 0;
    if (file >= 0) ::close(file);
    if (failure == 0 && ::rename(part_.c_str(), target.c_str()) != 0) failure = errno;
    if (failure != 0)
        throw Error(fmt::format("cannot write {}: {}", path_.string(), std::generic_category().message(failure)));
}

void VideoFile::fail() {
    if (StopSignals::count() > 1) encoder_.kill();
    encoder_.finish();
    throw Error(fmt::format("cannot write {}: ffmpeg ended after {} frames with {}", path_.string(), frames_,
                            encoder_.lastWords()));
}

}  // namespace timeshade
