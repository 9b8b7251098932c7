#pragma once

#include <optional>
#include <string>

#include "record/video_codec.h"

namespace timeshade {

/// What an output is, by its ending: .mp4, .mov, .mkv, .webm, .gif, in capitals too.
enum class VideoContainer { Mp4, Mov, Matroska, WebM, Gif };

/// Nothing for a folder: a path without an ending or with a slash at its end, or a folder that is there. Throws
/// UsageError that names any other ending, so that none is taken for a folder's.
std::optional<VideoContainer> containerOf(const std::string& output);

/// The codec to be used; `asked` where the container can hold it, otherwise UsageError. Nothing for GIF, which has none
/// to choose. Default: H.264, in WebM AV1.
std::optional<VideoCodec> codecIn(VideoContainer container, std::optional<VideoCodec> asked);

/// ffmpeg's name of the container.
std::string muxerOf(VideoContainer container);

}  // namespace timeshade
