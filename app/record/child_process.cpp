#include "record/child_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"
#include "core/one_line.h"
#include "record/spawn_attributes.h"
#include "record/stop_signals.h"

extern char** environ;

namespace timeshade {

namespace {

constexpr int signalsThatGiveUp = 2;  // the first one lets the file be finished

[[noreturn]] void failStarting(const std::string& program, int code) {
    const std::string expected = code == ENOENT ? fmt::format("; expected the program {} on PATH", program) : "";
    throw Error(fmt::format("cannot start {}: {}{}", program, std::generic_category().message(code), expected));
}

/// Which of our descriptors become the child's. All others are closed, those that libraries have opened included.
class SpawnActions {
  public:
    SpawnActions(int input, int output, int log, int handed) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions_, log, STDERR_FILENO);
        posix_spawn_file_actions_adddup2(&actions_, handed, ChildProcess::handedDescriptor);
        posix_spawn_file_actions_addclosefrom_np(&actions_, ChildProcess::handedDescriptor + 1);
    }
    ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;
    const posix_spawn_file_actions_t* get() const { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_;
};

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command, int handed) {
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    // A socket, since writing to one whose reader is gone can be told to raise no signal.
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) failStarting(command.front(), errno);
    input_ = ends[0];
    output_ = ::memfd_create("child's standard output", MFD_CLOEXEC);
    log_ = ::memfd_create("child's standard error", MFD_CLOEXEC);
    const SpawnActions actions(ends[1], output_, log_, handed);
    const SpawnAttributes attributes(SpawnAttributes::Group::Own);
    const int failure = log_ < 0 || output_ < 0 ? errno
                                                : ::posix_spawnp(&id_, arguments.front(), actions.get(),
                                                                 attributes.get(), arguments.data(), environ);
    ::close(ends[1]);
    if (failure == 0) return;
    id_ = -1;
    closeInput();
    if (output_ >= 0) ::close(output_);
    if (log_ >= 0) ::close(log_);
    failStarting(command.front(), failure);
}

ChildProcess::~ChildProcess() {
    kill();
    ::close(output_);
    ::close(log_);
}

bool ChildProcess::feed(std::span<const char> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR && StopSignals::count() < signalsThatGiveUp) continue;
        if (sent < 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

bool ChildProcess::finish() {
    closeInput();
    wait();
    return WIFEXITED(status_) && WEXITSTATUS(status_) == 0;
}

void ChildProcess::kill() {
    if (id_ > 0) ::kill(id_, SIGKILL);
    closeInput();
    wait();
}

void ChildProcess::closeInput() {
    if (input_ >= 0) ::close(std::exchange(input_, -1));
}

void ChildProcess::wait() {
    while (id_ > 0) {
        const pid_t ended = ::waitpid(id_, &status_, 0);
        if (ended < 0 && errno == EINTR) {
            if (StopSignals::count() >= signalsThatGiveUp) ::kill(id_, SIGKILL);
            continue;
        }
        id_ = -1;
    }
}

bool ChildProcess::complained() const { return ::lseek(log_, 0, SEEK_END) > 0; }

std::string ChildProcess::said() const {
    std::string text(65536, '\0');
    const ssize_t length = ::pread(output_, text.data(), text.size(), 0);
    text.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
    return text;
}

std::string ChildProcess::lastWords() {
    std::string text(4096, '\0');
    const off_t size = ::lseek(log_, 0, SEEK_END);
    const ssize_t length = ::pread(log_, text.data(), text.size(), size > 4096 ? size - 4096 : 0);
    text.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
    const std::string last = lastLine(text, 200);
    const std::string how = WIFSIGNALED(status_) ? fmt::format("signal {}", WTERMSIG(status_))
                                                 : fmt::format("exit code {}", WEXITSTATUS(status_));
    return last.empty() ? how : how + ": " + last;
}

}  // namespace timeshade
