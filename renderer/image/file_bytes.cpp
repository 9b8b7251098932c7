#include "image/file_bytes.h"

#include "core/error.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

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
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (file == nullptr) {
        failReading(path, errno);
    }
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
