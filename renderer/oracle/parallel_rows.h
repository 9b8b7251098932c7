#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace timeshade::oracle {

/// Calls work(row) for every row below `rows`, on all cores, a few rows at a time. Results must not depend on the
/// order. `work` must not throw.
template <class Work>
void forEachRow(std::uint32_t rows, const Work& work) {
    constexpr std::uint32_t rowsPerTask = 4;
    std::atomic<std::uint32_t> next{0};
    const auto run = [&] {
        for (std::uint32_t first = next.fetch_add(rowsPerTask); first < rows; first = next.fetch_add(rowsPerTask))
            for (std::uint32_t row = first; row < std::min(first + rowsPerTask, rows); ++row) work(row);
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) threads.emplace_back(run);
    run();
}

}  // namespace timeshade::oracle
