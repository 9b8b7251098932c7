#pragma once

#include <filesystem>
#include <string>

#include "image/part_file.h"
#include "record/child_process.h"
#include "record/frame_sink.h"
#include "record/video_container.h"

namespace timeshade {

struct VideoFormat {
    int width = 640, height = 360;  ///< even but for GIF: colour is kept at half the resolution, as players expect
    double framesPerSecond = 24.0;
    VideoContainer container = VideoContainer::Mp4;
    std::optional<VideoCodec> codec = VideoCodec::H264;  ///< one that the container can hold (codecIn())
    int quality = 18;  ///< the encoder's constant rate factor, 0 .. 51: less is better and larger
};

/// A video, made by the program ffmpeg from raw frames. It grows under a temporary name beside the path (PartFile) and
/// is renamed once it has been read back whole (requireFinishedVideo); the encoder is handed the open file, never a
/// name. Should this process be killed, ffmpeg
/// closes the temporary file, which can then be played.
class VideoFile final : public FrameSink {
  public:
    /// Throws Error where ffmpeg or ffprobe can't be started or the path can't be written to, UsageError for an odd
    /// size.
    VideoFile(std::filesystem::path path, const VideoFormat& format);
    ~VideoFile() override;

    void add(const DisplayImage& frame) override;
    void finish() override;
    std::string kept() const override { return path_.string(); }

  private:
    [[noreturn]] void fail();

    std::filesystem::path path_;
    double framesPerSecond_;
    PartFile part_;
    ChildProcess encoder_;
    int frames_ = 0;
};

}  // namespace timeshade
