#include "window/shader_watch.h"

#include <utility>

#include "gl/shader_source.h"

namespace timeshade {

namespace {

constexpr double secondsBetweenLooks = 0.5;

/// A folder that is not there, or goes while it is read, has no files.
std::map<std::filesystem::path, std::filesystem::file_time_type> timesOfShaders() {
    std::map<std::filesystem::path, std::filesystem::file_time_type> times;
    std::error_code failure;
    std::filesystem::recursive_directory_iterator file(gl::shaderDirectory(), failure);
    for (; !failure && file != std::filesystem::recursive_directory_iterator(); file.increment(failure)) {
        std::error_code gone;
        const auto time = file->last_write_time(gone);
        if (!gone && file->is_regular_file(gone)) times[file->path()] = time;
    }
    return times;
}

}  // namespace

ShaderWatch::ShaderWatch() : times_(timesOfShaders()) {}

bool ShaderWatch::changed(double now) {
    if (now - lastLook_ < secondsBetweenLooks) return false;
    lastLook_ = now;
    auto times = timesOfShaders();
    if (times == times_) return false;
    times_ = std::move(times);
    return true;
}

}  // namespace timeshade
