#include "window/scene_loading.h"

#include <utility>

#include "loading_line.h"

namespace timeshade {

namespace {

using namespace std::chrono_literals;

// Until then the window stands still, as after any other click; later it says what it is waiting for.
constexpr auto untilShown = 60ms;

}  // namespace

void SceneLoading::begin(const std::string& name, Load load) {
    cancel();
    name_ = name;
    begin_ = std::chrono::steady_clock::now();
    shared_ = std::make_shared<Shared>();
    const auto watch = [shared = shared_](const LoadingStep& step) {
        if (shared->cancelled) throw LoadingCancelled();
        const std::lock_guard lock(shared->mutex);
        shared->step = step;
    };
    future_ = std::async(std::launch::async, [load = std::move(load), watch] { return load(watch); });
    future_.wait_for(untilShown);
}

void SceneLoading::cancel() {
    if (!on()) return;
    shared_->cancelled = true;
    std::erase_if(givenUp_, [](const auto& one) { return one.wait_for(0s) == std::future_status::ready; });
    givenUp_.push_back(std::exchange(future_, {}));
}

std::unique_ptr<Scene> SceneLoading::take() {
    if (!on() || future_.wait_for(0s) != std::future_status::ready) return nullptr;
    return std::exchange(future_, {}).get();
}

std::string SceneLoading::text() const {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin_;
    const std::lock_guard lock(shared_->mutex);
    return loadingText(name_, shared_->step, spent.count());
}

}  // namespace timeshade
