#include "core/file_bytes.h"

#include "core/error.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdint>
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

std::vector<unsigned char> readFileBytes(const std::filesystem::path& path, std::size_t most) {
    // Not blocking: a pipe in a file's place would be waited for until somebody writes into it.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) failReading(path, errno);
    const std::unique_ptr<std::FILE, CloseFile> file(::fdopen(descriptor, "rb"));
    struct stat status {};
    if (!file || ::fstat(descriptor, &status) != 0) failReading(path, errno);
    if (S_ISDIR(status.st_mode)) failReading(path, EISDIR);
    if (!S_ISREG(status.st_mode)) throw Error(fmt::format("cannot read {}: is not a regular file", path.string()));
    const auto refuseSize = [&] {
        throw Error(fmt::format("cannot read {}: has more than {} bytes", path.string(), most));
    };
    if (static_cast<std::uintmax_t>(status.st_size) > most) refuseSize();
    std::vector<unsigned char> bytes;
    std::array<unsigned char, 65536> block;
    std::size_t count = 0;
    while ((count = std::fread(block.data(), 1, block.size(), file.get())) > 0) {
        if (count > most - bytes.size()) refuseSize();  // it has grown, or has no size of its own, as in /proc
        bytes.insert(bytes.end(), block.data(), block.data() + count);
    }
    if (std::ferror(file.get()) != 0) {
        failReading(path, errno);
    }
    return bytes;
}

std::string readFileText(const std::filesystem::path& path, std::size_t most) {
    const std::vector<unsigned char> bytes = readFileBytes(path, most);
    return {bytes.begin(), bytes.end()};
}

}  // namespace timeshade
