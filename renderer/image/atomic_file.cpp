#include "core/error.h"
#include "image/image_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <system_error>
#include <utility>

namespace timeshade {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failWriting(const fs::path& path, int code, std::string_view expected = {}) {
    throw Error(fmt::format("cannot write {}: {}{}{}", path.string(), std::generic_category().message(code),
                            expected.empty() ? "" : "; expected ", expected));
}

/// A file descriptor that is closed on every return and exception.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) {
            ::close(number_);
        }
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return number_; }
    /// The errno of close(), or 0: some file systems report a full disk only here.
    int close() { return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno; }

  private:
    int number_;
};

/// What is at the path now, with symbolic links resolved.
struct Target {
    fs::path file;               ///< the resolved path; renaming onto it keeps the links
    std::optional<mode_t> mode;  ///< permissions of the existing file
    bool isStream = false;       ///< a device or a pipe: written to, never replaced
};

/// Resolves links to a file that does not exist yet. The caller has made sure that they form no cycle.
fs::path followLinks(fs::path path) {
    std::error_code failed;
    while (fs::is_symlink(fs::symlink_status(path, failed))) {
        const fs::path next = fs::read_symlink(path, failed);
        if (failed) {
            break;
        }
        path = path.parent_path() / next;
    }
    return path;
}

Target inspectTarget(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) {
        if (errno != ENOENT) {
            failWriting(path, errno);
        }
        return {followLinks(path), std::nullopt, false};
    }
    if (S_ISDIR(status.st_mode)) {
        failWriting(path, EISDIR, "a file name");
    }
    // Renaming would replace even a file that is read-only.
    if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) {
        failWriting(path, errno);
    }
    if (!S_ISREG(status.st_mode)) {
        return {path, std::nullopt, true};
    }
    std::error_code failed;
    fs::path file = fs::canonical(path, failed);
    return {failed ? path : file, status.st_mode & 07777, false};
}

/// A new file beside the target. It is deleted unless it is renamed onto the target.
class PartFile {
  public:
    PartFile(const fs::path& path, const Target& target) : path_(path), target_(target) {
        descriptor_.emplace(create());
    }

    ~PartFile() {
        if (!renamed_) {
            ::unlink(part_.c_str());
        }
    }
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    int descriptor() const { return descriptor_->number(); }

    void renameOntoTarget() {
        if (target_.mode && ::fchmod(descriptor(), *target_.mode) != 0) {
            failWriting(path_, errno);
        }
        if (::fsync(descriptor()) != 0) {
            failWriting(path_, errno);
        }
        if (const int code = descriptor_->close(); code != 0) {
            failWriting(path_, code);
        }
        if (::rename(part_.c_str(), target_.file.c_str()) != 0) {
            failWriting(path_, errno);
        }
        renamed_ = true;
    }

  private:
    int create() {
        const fs::path folder = target_.file.parent_path().empty() ? fs::path(".") : target_.file.parent_path();
        // Leaves room for the suffix where the name has the greatest length that is allowed.
        const std::string stem = target_.file.filename().string().substr(0, 200);
        for (int attempt = 0;; ++attempt) {
            part_ = folder / fmt::format("{}.{}-{}.part", stem, ::getpid(), attempt);
            const int number = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (number >= 0) {
                return number;
            }
            // Left by a killed process that had the same process id, or in use by another thread.
            if (errno == EEXIST && attempt < 1000) {
                continue;
            }
            const int code = errno;
            const bool missing = code == ENOENT || code == ENOTDIR;
            failWriting(path_, code, missing ? fmt::format("an existing folder {}", folder.string()) : "");
        }
    }

    const fs::path& path_;
    const Target& target_;
    fs::path part_;
    std::optional<Descriptor> descriptor_;
    bool renamed_ = false;
};

void writeAll(const fs::path& path, int descriptor, std::span<const char> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) {
            continue;
        }
        if (written <= 0) {
            failWriting(path, written < 0 ? errno : ENOSPC);
        }
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void writeStream(const fs::path& path, std::span<const char> bytes) {
    Descriptor stream(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (stream.number() < 0) {
        failWriting(path, errno);
    }
    writeAll(path, stream.number(), bytes);
    if (const int code = stream.close(); code != 0) {
        failWriting(path, code);
    }
}

void requireFileName(const fs::path& path) {
    if (!path.has_filename()) {
        failWriting(path.empty() ? "\"\"" : path, path.empty() ? ENOENT : EISDIR, "a file name");
    }
}

}  // namespace

void writeFileAtomically(const fs::path& path, std::span<const char> bytes) {
    requireFileName(path);
    const Target target = inspectTarget(path);
    if (target.isStream) {
        writeStream(path, bytes);
        return;
    }
    PartFile part(path, target);
    writeAll(path, part.descriptor(), bytes);
    part.renameOntoTarget();
}

void requireWritable(const fs::path& path) {
    requireFileName(path);
    const Target target = inspectTarget(path);
    if (!target.isStream) {
        // Read-only mounts, quotas and access lists can only be found out by trying.
        const PartFile part(path, target);
    }
}

}  // namespace timeshade
