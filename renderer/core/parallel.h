#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace timeshade {

/// Calls work(first, end) for ranges that together are 0 .. count - 1, each of at most `together`, on all cores; on the
/// caller's own where there is but one range. Results must not depend on the order. `work` must not throw.
template <class Work>
void forRanges(std::size_t count, std::size_t together, const Work& work) {
    if (count <= together) {
        if (count > 0) work(std::size_t{0}, count);
        return;
    }
    std::atomic<std::size_t> next{0};
    const auto run = [&] {
        for (std::size_t first = next.fetch_add(together); first < count; first = next.fetch_add(together))
            work(first, std::min(first + together, count));
    };
    const std::size_t ranges = (count + together - 1) / together,
                      cores = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < std::min(cores, ranges); ++i) threads.emplace_back(run);
    run();
}

/// The same, with work(i) for each.
template <class Work>
void forEachOf(std::size_t count, std::size_t together, const Work& work) {
    forRanges(count, together, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) work(i);
    });
}

}  // namespace timeshade
