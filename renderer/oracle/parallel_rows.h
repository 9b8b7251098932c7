#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include "core/pause.h"

namespace timeshade::oracle {

/// Calls work(row) for every row in [begin, end), on all cores, a few rows at a time.
template <class Work>
void runRows(std::uint32_t begin, std::uint32_t end, const Work& work) {
    constexpr std::uint32_t rowsPerTask = 4;
    std::atomic<std::uint32_t> next{begin};
    const auto run = [&] {
        for (std::uint32_t first = next.fetch_add(rowsPerTask); first < end; first = next.fetch_add(rowsPerTask))
            for (std::uint32_t row = first; row < std::min(first + rowsPerTask, end); ++row) work(row);
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) threads.emplace_back(run);
    run();
}

/// The same for every row below `rows`. Results must not depend on the order. `work` must not throw. Where work may
/// pause, it does so between runs of rows.
template <class Work>
void forEachRow(std::uint32_t rows, const Work& work) {
    const std::uint32_t step = pauseHook() == nullptr ? rows : 8 * std::max(1u, std::thread::hardware_concurrency());
    for (std::uint32_t begin = 0; begin < rows; begin += step) {
        runRows(begin, std::min(begin + step, rows), work);
        pausePoint();
    }
}

}  // namespace timeshade::oracle
