#include "loading_line.h"

#include <filesystem>
#include <utility>

#include <unistd.h>

#include <fmt/format.h>

#include "core/one_line.h"
#include "standard_error.h"

namespace timeshade {

namespace {

constexpr std::chrono::milliseconds untilShown{1000}, betweenLines{200};

}  // namespace

std::string loadingText(const std::string& scene, const LoadingStep& step, double seconds) {
    const std::string name = oneLine(std::filesystem::path(scene).filename().string(), 40);
    const std::string parts = step.whole > 0 ? fmt::format(" {} of {}", step.done + 1, step.whole) : "";
    return fmt::format("loading {}: {}{}, {:.0f} s", name, step.name, parts, seconds);
}

LoadingLine::LoadingLine(std::string scene) : scene_(std::move(scene)) {
    if (isatty(STDERR_FILENO) == 1) writer_ = std::thread([this] { write(); });
}

LoadingLine::~LoadingLine() {
    if (!writer_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        end_ = true;
    }
    ended_.notify_one();
    writer_.join();
}

void LoadingLine::show(const LoadingStep& step) {
    const std::lock_guard lock(mutex_);
    step_ = step;
}

void LoadingLine::write() {
    std::unique_lock lock(mutex_);
    const auto isEnd = [this] { return end_; };
    if (ended_.wait_for(lock, untilShown, isEnd)) return;
    do {
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin_;
        writeToStandardError("\r\033[Ktimeshade: " + loadingText(scene_, step_, spent.count()));
    } while (!ended_.wait_for(lock, betweenLines, isEnd));
    writeToStandardError("\r\033[K");
}

}  // namespace timeshade
