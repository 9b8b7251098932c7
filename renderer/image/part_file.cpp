#include "image/part_file.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "image/part_name.h"

namespace timeshade {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void failWriting(const fs::path& path, int code, std::string_view expected = {}) {
    throw Error(fmt::format("cannot write {}: {}{}{}", path.string(), std::generic_category().message(code),
                            expected.empty() ? "" : "; expected ", expected));
}

}  // namespace

fs::path followOwnLinks(const fs::path& path) {
    constexpr int mostLinks = 40;  // as the kernel
    fs::path at = path;
    for (int i = 0; i < mostLinks; ++i) {
        struct stat status {};
        if (::lstat(at.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) return at;
        if (status.st_uid != ::geteuid() && status.st_uid != 0)
            throw Error(
                fmt::format("cannot write {}: {} is a link that belongs to another user; expected a file, or a "
                            "link of one's own",
                            path.string(), at.string()));
        std::error_code failed;
        const fs::path next = fs::read_symlink(at, failed);
        if (failed) failWriting(path, failed.value());
        at = at.parent_path() / next;
    }
    failWriting(path, ELOOP);
}

TargetKind kindOfTarget(const fs::path& path) {
    if (!path.has_filename()) {
        const bool empty = path.empty();
        failWriting(empty ? "\"\"" : path, empty ? ENOENT : EISDIR, "a file name");
    }
    const fs::path target = followOwnLinks(path);
    struct stat status {};
    if (::stat(target.c_str(), &status) != 0) {
        if (errno != ENOENT) failWriting(path, errno);
        return TargetKind::Nothing;
    }
    if (S_ISDIR(status.st_mode)) failWriting(path, EISDIR, "a file name");
    // Renaming would replace even a file that is read-only.
    if (::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) failWriting(path, errno);
    return S_ISREG(status.st_mode) ? TargetKind::File : TargetKind::Stream;
}

PartFile::PartFile(fs::path path) : path_(std::move(path)), target_(followOwnLinks(path_)) {
    struct stat status {};
    if (::stat(target_.c_str(), &status) == 0) mode_ = status.st_mode & 07777;
    removeLeftovers();
    create();
}

PartFile::~PartFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(part_.c_str());
}

void PartFile::create() {
    const fs::path folder = folderOfParts(target_);
    for (;;) {
        part_ = newPartName(target_);
        descriptor_ = ::open(part_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && errno == EEXIST) continue;
        if (descriptor_ < 0) {
            const int code = errno;
            const bool missing = code == ENOENT || code == ENOTDIR;
            failWriting(path_, code, missing ? fmt::format("an existing folder {}", folder.string()) : "");
        }
        // Another program that tidies up may have been between the two calls: then this part is gone already.
        struct stat status {};
        ::flock(descriptor_, LOCK_EX | LOCK_NB);
        if (::fstat(descriptor_, &status) == 0 && status.st_nlink > 0) return;
        ::close(descriptor_);
    }
}

void PartFile::removeLeftovers() const {
    DIR* const folder = ::opendir(folderOfParts(target_).c_str());
    if (folder == nullptr) return;  // create() says why
    const std::string stem = stemOfParts(target_);
    while (const dirent* entry = ::readdir(folder)) {
        if (!isPartName(entry->d_name, stem)) continue;
        const int part = ::openat(::dirfd(folder), entry->d_name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (part < 0) continue;
        struct stat status {};
        const bool ours = ::fstat(part, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid();
        if (ours && ::flock(part, LOCK_EX | LOCK_NB) == 0) ::unlinkat(::dirfd(folder), entry->d_name, 0);
        ::close(part);
    }
    ::closedir(folder);
}

void writeAll(const fs::path& path, int descriptor, std::span<const char> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) failWriting(path, written < 0 ? errno : ENOSPC);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void PartFile::write(std::span<const char> bytes) { writeAll(path_, descriptor_, bytes); }

void PartFile::renameOntoTarget() {
    if (mode_ && ::fchmod(descriptor_, *mode_) != 0) failWriting(path_, errno);
    if (::fsync(descriptor_) != 0) failWriting(path_, errno);
    // Some file systems report a full disk only here.
    if (::close(std::exchange(descriptor_, -1)) != 0) failWriting(path_, errno);
    if (::rename(part_.c_str(), target_.c_str()) != 0) failWriting(path_, errno);
    renamed_ = true;
}

}  // namespace timeshade
