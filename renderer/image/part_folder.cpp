#include "image/part_folder.h"

#include <cerrno>
#include <system_error>
#include <utility>
#include <vector>

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

[[noreturn]] void failMaking(const fs::path& path, int code) {
    throw Error(fmt::format("cannot make {}: {}", path.string(), std::generic_category().message(code)));
}

/// As a new folder has them, by the process's mask, which can only be read by setting it.
mode_t usualPermissions() {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0777 & ~mask;
}

}  // namespace

PartFolder::PartFolder(fs::path target) : target_(std::move(target)) {
    removeLeftovers();
    for (;;) {
        part_ = newPartName(target_);
        if (::mkdir(part_.c_str(), 0700) == 0) break;
        if (errno != EEXIST) failMaking(target_, errno);
    }
    descriptor_ = ::open(part_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor_ < 0) failMaking(target_, errno);
    ::flock(descriptor_, LOCK_EX | LOCK_NB);
}

PartFolder::~PartFolder() {
    std::error_code ignored;
    if (!renamed_) fs::remove_all(part_, ignored);
    ::close(descriptor_);
}

void PartFolder::renameOntoTarget() {
    if (::fchmod(descriptor_, usualPermissions()) != 0) failMaking(target_, errno);
    std::error_code ignored;
    fs::remove(target_, ignored);  // what is empty, or a link in its place
    if (::rename(part_.c_str(), target_.c_str()) != 0) failMaking(target_, errno);
    renamed_ = true;
}

void PartFolder::removeLeftovers() const {
    const std::string stem = stemOfParts(target_);
    std::vector<fs::path> leftovers;
    std::error_code failed;
    for (fs::directory_iterator it(folderOfParts(target_), failed), end; !failed && it != end; it.increment(failed))
        if (isPartName(it->path().filename().string(), stem)) leftovers.push_back(it->path());
    for (const fs::path& leftover : leftovers) {
        const int folder = ::open(leftover.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        if (folder < 0) continue;  // a file, or another user's
        struct stat status {};
        const bool ours = ::fstat(folder, &status) == 0 && status.st_uid == ::geteuid();
        if (ours && ::flock(folder, LOCK_EX | LOCK_NB) == 0) fs::remove_all(leftover, failed);
        ::close(folder);
    }
}

}  // namespace timeshade
