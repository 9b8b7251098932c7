#include "record/video_check.h"

#include <cmath>
#include <cstdlib>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "record/child_process.h"

namespace timeshade {

namespace {

/// ffprobe writes numbers as text.
double numberAt(const nlohmann::json& json, const char* pointer) {
    const nlohmann::json::json_pointer place(pointer);
    if (!json.is_object() || !json.contains(place) || !json[place].is_string()) return -1.0;
    return std::strtod(json[place].get<std::string>().c_str(), nullptr);
}

}  // namespace

void requireFinishedVideo(int descriptor, int frames, double framesPerSecond) {
    ChildProcess probe({"ffprobe", "-v", "error", "-count_packets", "-select_streams", "v", "-show_entries",
                        "stream=nb_read_packets:format=duration", "-of", "json",
                        fmt::format("file:/proc/self/fd/{}", ChildProcess::handedDescriptor)},
                       descriptor);
    // It ends with 0 after the last frame of a file that has been cut off, too, and complains.
    if (!probe.finish() || probe.complained())
        throw Error(fmt::format("it cannot be read back: ffprobe ended with {}", probe.lastWords()));
    const nlohmann::json found = nlohmann::json::parse(probe.said(), nullptr, false);
    const double packets = numberAt(found, "/streams/0/nb_read_packets"), seconds = numberAt(found, "/format/duration");
    if (packets != frames) throw Error(fmt::format("read back it holds {:g} frames, expected {}", packets, frames));
    // Containers round times, GIF to hundredths of a second, and not all count the last frame's own.
    const double expected = frames / framesPerSecond, tolerance = 1.5 / framesPerSecond + 0.02 + 0.005 * frames;
    if (!(std::abs(seconds - expected) <= tolerance))
        throw Error(fmt::format("read back it lasts {:g} s, expected {:g} s", seconds, expected));
}

void requireVideoCheck(int descriptor) {
    ChildProcess probe({"ffprobe", "-version"}, descriptor);
    probe.finish();
}

}  // namespace timeshade
