#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "scene/loading.h"

namespace timeshade {

/// "loading big.glb: meshes 3 of 17, 4 s" of a step: what a person is told.
std::string loadingText(const std::string& scene, const LoadingStep& step, double seconds);

/// What a scene that is being loaded is at, on standard error where that is a terminal: after a second, one line that
/// is written over and wiped at the end. A thread of its own writes it, since a step may be long.
class LoadingLine {
  public:
    explicit LoadingLine(std::string scene);
    ~LoadingLine();
    LoadingLine(const LoadingLine&) = delete;
    LoadingLine& operator=(const LoadingLine&) = delete;

    void show(const LoadingStep& step);

  private:
    void write();

    std::string scene_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    std::mutex mutex_;
    std::condition_variable ended_;
    LoadingStep step_;
    bool end_ = false;
    std::thread writer_;  ///< none where standard error is no terminal
};

}  // namespace timeshade
