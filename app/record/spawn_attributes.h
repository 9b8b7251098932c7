#pragma once

#include <csignal>

#include <spawn.h>

namespace timeshade {

/// Gives a child the signals that this process ignores or catches as they were meant; and, where it is to outlive the
/// Ctrl-C of a terminal, a process group of its own.
class SpawnAttributes {
  public:
    enum class Group { OfParent, Own };
    explicit SpawnAttributes(Group group) {
        posix_spawnattr_init(&attributes_);
        const int own = group == Group::Own ? POSIX_SPAWN_SETPGROUP : 0;
        posix_spawnattr_setflags(&attributes_,
                                 static_cast<short>(own | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK));
        posix_spawnattr_setpgroup(&attributes_, 0);
        sigset_t signals;
        sigfillset(&signals);
        posix_spawnattr_setsigdefault(&attributes_, &signals);
        sigemptyset(&signals);
        posix_spawnattr_setsigmask(&attributes_, &signals);
    }
    ~SpawnAttributes() { posix_spawnattr_destroy(&attributes_); }
    SpawnAttributes(const SpawnAttributes&) = delete;
    SpawnAttributes& operator=(const SpawnAttributes&) = delete;
    const posix_spawnattr_t* get() const { return &attributes_; }

  private:
    posix_spawnattr_t attributes_;
};

}  // namespace timeshade
