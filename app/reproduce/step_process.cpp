#include "reproduce/step_process.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include "core/error.h"
#include "record/spawn_attributes.h"
#include "record/stop_signals.h"

extern char** environ;

namespace timeshade {

namespace {

constexpr int readable = 0644;

/// The folder that the child works in, and where its three standard streams lead.
class StepFiles {
  public:
    explicit StepFiles(const std::filesystem::path& folder) {
        constexpr int fresh = O_WRONLY | O_CREAT | O_TRUNC;
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
        posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, 1, "said.txt", fresh, readable);
        posix_spawn_file_actions_addopen(&actions_, 2, "complained.txt", fresh, readable);
        posix_spawn_file_actions_addclosefrom_np(&actions_, 3);
    }
    ~StepFiles() { posix_spawn_file_actions_destroy(&actions_); }
    StepFiles(const StepFiles&) = delete;
    StepFiles& operator=(const StepFiles&) = delete;
    const posix_spawn_file_actions_t* get() const { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_;
};

/// A step works in another folder than this program: where data lies must not depend on it.
void makeDataPathsAbsolute() {
    for (const char* name : {"TIMESHADE_DATA", "TIMESHADE_SHADERS", "TIMESHADE_SCENES"})
        if (const char* path = std::getenv(name); path && *path != '\0')
            ::setenv(name, std::filesystem::absolute(path).c_str(), 1);
}

int waitFor(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) return -1;
        if (StopSignals::count() > 0) ::kill(child, SIGTERM);
    }
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

int runThisProgram(const std::vector<std::string>& arguments, const std::filesystem::path& folder) {
    std::vector<std::string> words{"timeshade"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    makeDataPathsAbsolute();
    const StepFiles files(folder);
    const SpawnAttributes signals(SpawnAttributes::Group::OfParent);
    pid_t child = -1;
    const int failure = ::posix_spawn(&child, "/proc/self/exe", files.get(), signals.get(), pointers.data(), environ);
    if (failure != 0)
        throw Error(fmt::format("{}: a step cannot be started there ({})", folder.string(),
                                std::generic_category().message(failure)));
    return waitFor(child);
}

}  // namespace timeshade
