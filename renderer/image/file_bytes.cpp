#include "image/file_bytes.h"

#include "core/error.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>

namespace timeshade {
namespace {

[[noreturn]] void failReading(const std::filesystem::path& path, int code) {
    throw Error(fmt::format("cannot read {}: {}", path.string(), std::generic_category().message(code)));
}

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

std::vector<unsigned char> readFileBytes(const std::filesystem::path& path) {
    // Not blocking: a pipe in a file's place would be waited for until somebody writes into it.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) failReading(path, errno);
    const std::unique_ptr<std::FILE, CloseFile> file(::fdopen(descriptor, "rb"));
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) failReading(path, errno);
    if (S_ISDIR(status.st_mode)) failReading(path, EISDIR);
    if (!S_ISREG(status.st_mode)) throw Error(fmt::format("cannot read {}: is not a regular file", path.string()));
    std::vector<unsigned char> bytes;
    std::array<unsigned char, 65536> block;
    std::size_t count = 0;
    while ((count = std::fread(block.data(), 1, block.size(), file.get())) > 0) {
        bytes.insert(bytes.end(), block.data(), block.data() + count);
    }
    if (std::ferror(file.get()) != 0) {
        failReading(path, errno);
    }
    return bytes;
}

}  // namespace timeshade
