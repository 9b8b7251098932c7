#include "shot_output.h"

#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fmt/format.h>

#include "core/error.h"
#include "image/png_bytes.h"
#include "standard_error.h"

namespace timeshade {

ShotOutput::ShotOutput(const std::string& output, int frames) : output_(output), frames_(frames) {
    if (!isStandardOutput()) {
        for (int i = 0; i < frames; ++i) requireWritable(path(i));
        return;
    }
    if (::isatty(STDOUT_FILENO) == 1)
        throw Error("-o -: standard output is a terminal, which shows no PNG; expected a pipe or a file");
}

std::filesystem::path ShotOutput::path(int frame) const {
    if (frames_ == 1) return output_;
    const std::filesystem::path path(output_);
    return path.parent_path() / fmt::format("{}.{:04}{}", path.stem().string(), frame, path.extension().string());
}

void ShotOutput::write(const std::filesystem::path& path, const DisplayImage& picture) const {
    if (!isStandardOutput()) return writePng(path, picture);
    const std::vector<char> bytes = pngBytes(path, picture);
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0)
        throw std::system_error(errno, std::generic_category(), "cannot write to standard output");
}

void ShotOutput::say(const std::string& text) const {
    if (isStandardOutput())
        writeToStandardError(text);
    else
        fmt::print("{}", text);
}

}  // namespace timeshade
