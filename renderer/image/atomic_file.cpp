#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "core/error.h"
#include "image/image_file.h"
#include "image/part_file.h"

namespace timeshade {

namespace {

[[noreturn]] void failWriting(const std::filesystem::path& path, int code) {
    throw Error(fmt::format("cannot write {}: {}", path.string(), std::generic_category().message(code)));
}

/// Of a device or a pipe.
class Stream {
  public:
    explicit Stream(const std::filesystem::path& path)
        : path_(path), descriptor_(::open(path.c_str(), O_WRONLY | O_CLOEXEC)) {
        if (descriptor_ < 0) failWriting(path, errno);
    }
    ~Stream() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    void write(std::span<const char> bytes) const { writeAll(path_, descriptor_, bytes); }
    void close() {
        if (::close(std::exchange(descriptor_, -1)) != 0) failWriting(path_, errno);
    }

  private:
    const std::filesystem::path& path_;
    int descriptor_;
};

}  // namespace

void writeFileAtomically(const std::filesystem::path& path, std::span<const char> bytes) {
    if (kindOfTarget(path) == TargetKind::Stream) {
        Stream stream(path);
        stream.write(bytes);
        stream.close();
        return;
    }
    PartFile part(path);
    part.write(bytes);
    part.renameOntoTarget();
}

void requireWritable(const std::filesystem::path& path) {
    // Read-only mounts, quotas and access lists can only be found out by trying.
    if (kindOfTarget(path) != TargetKind::Stream) const PartFile part(path);
}

}  // namespace timeshade
