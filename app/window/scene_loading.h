#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "scene/loading.h"
#include "scene/scene.h"

namespace timeshade {

/// A scene that is loaded by another thread while the window goes on showing the one before. One at a time.
class SceneLoading {
  public:
    using Load = std::function<std::unique_ptr<Scene>(const LoadingWatch&)>;

    SceneLoading() = default;
    /// Waits for threads whose scenes were given up: each ends before its next step.
    ~SceneLoading() { cancel(); }
    SceneLoading(const SceneLoading&) = delete;
    SceneLoading& operator=(const SceneLoading&) = delete;

    /// Begins, in place of what is being loaded now. `name` is for text(). Waits for a moment: most scenes are there
    /// before it has passed.
    void begin(const std::string& name, Load load);
    /// Gives up what is being loaded, if anything, and does not wait for it.
    void cancel();

    bool on() const { return future_.valid(); }
    /// The scene, once; nothing while it is not there yet. Throws what loading threw.
    std::unique_ptr<Scene> take();
    /// What it is at: "loading big.glb: meshes 3 of 17, 4 s".
    std::string text() const;

  private:
    /// Shared with the thread.
    struct Shared {
        std::mutex mutex;
        LoadingStep step;
        std::atomic<bool> cancelled = false;
    };

    std::string name_;
    std::chrono::steady_clock::time_point begin_;
    std::shared_ptr<Shared> shared_;
    std::future<std::unique_ptr<Scene>> future_;
    std::vector<std::future<std::unique_ptr<Scene>>> givenUp_;
};

}  // namespace timeshade
