#pragma once

#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

namespace timeshade {

/// Another program that is fed through its standard input; what it writes to standard output and standard error is
/// kept. It is in a process group of its own, so that Ctrl-C reaches it only through us. When this process dies, its
/// input ends.
class ChildProcess {
  public:
    /// The number under which the child has the descriptor that it is handed.
    static constexpr int handedDescriptor = 3;

    /// Starts `command.front()`, found on PATH. Of this process's descriptors it gets `handed` alone, its standard ones
    /// aside. Throws Error that names it where that fails.
    ChildProcess(const std::vector<std::string>& command, int handed);
    /// Kills it where it still runs, and leaves no zombie.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Writes all of the bytes. False where it no longer listens (no SIGPIPE), or where a second stop signal came
    /// meanwhile.
    bool feed(std::span<const char> bytes);
    /// Ends its input and waits for it; a second stop signal kills it. True if it has ended with exit code 0.
    bool finish();
    void kill();
    /// How it ended: "exit code 1" or "signal 9", and the last line that it said.
    std::string lastWords();
    /// Whether it has written anything to standard error.
    bool complained() const;
    /// What it has written to standard output, at most 64 KiB of it.
    std::string said() const;

  private:
    void closeInput();
    /// Returns once the process is gone.
    void wait();

    pid_t id_ = -1;  ///< -1 once it has been waited for
    int input_ = -1;
    int output_ = -1;
    int log_ = -1;
    int status_ = 0;
};

}  // namespace timeshade
