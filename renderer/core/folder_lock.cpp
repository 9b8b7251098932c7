#include "core/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0)
        throw Error(fmt::format("{}: cannot be opened ({})", folder.string(), std::generic_category().message(errno)));
    if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    close(descriptor_);
    throw Error(
        fmt::format("{}: another timeshade is writing into this folder; expected one at a time", folder.string()));
}

FolderLock::~FolderLock() { close(descriptor_); }

}  // namespace timeshade
