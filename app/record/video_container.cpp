#include "record/video_container.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade {

namespace {

constexpr std::array<std::pair<const char*, VideoContainer>, 5> endings{{{".mp4", VideoContainer::Mp4},
                                                                         {".mov", VideoContainer::Mov},
                                                                         {".mkv", VideoContainer::Matroska},
                                                                         {".webm", VideoContainer::WebM},
                                                                         {".gif", VideoContainer::Gif}}};

const char* endingOf(VideoContainer container) {
    return std::find_if(endings.begin(), endings.end(), [&](const auto& ending) { return ending.second == container; })
        ->first;
}

const char* nameOf(VideoCodec codec) {
    switch (codec) {
    case VideoCodec::H264: return "h264";
    case VideoCodec::Hevc: return "hevc";
    case VideoCodec::Av1: return "av1";
    }
    return "";
}

}  // namespace

std::optional<VideoContainer> containerOf(const std::string& output) {
    std::string ending = std::filesystem::path(output).extension().string();
    std::error_code failure;
    if (ending.empty() || ending == "." || std::filesystem::is_directory(output, failure)) return std::nullopt;
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
    for (const auto& [name, container] : endings)
        if (ending == name) return container;
    throw UsageError(fmt::format(
        "-o {}: the ending {} is none of a video; expected .mp4, .mov, .mkv, .webm or .gif, or a folder for "
        "pictures: without an ending, or with a slash at its end",
        output, ending));
}

std::optional<VideoCodec> codecIn(VideoContainer container, std::optional<VideoCodec> asked) {
    const auto refuse = [&](const char* expected) {
        throw UsageError(fmt::format("--codec {}: a {} file cannot hold it; expected {}", nameOf(*asked),
                                     endingOf(container), expected));
    };
    if (container == VideoContainer::Gif) {
        if (asked) refuse("none");
        return std::nullopt;
    }
    if (container == VideoContainer::WebM) {
        if (asked && *asked != VideoCodec::Av1) refuse("av1");
        return VideoCodec::Av1;
    }
    if (container == VideoContainer::Mov && asked == VideoCodec::Av1) refuse("h264 or hevc");
    return asked.value_or(VideoCodec::H264);
}

std::string muxerOf(VideoContainer container) {
    return container == VideoContainer::Matroska ? "matroska" : endingOf(container) + 1;
}

}  // namespace timeshade
