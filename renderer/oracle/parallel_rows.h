#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>

#include "core/parallel.h"
#include "core/pause.h"

namespace timeshade::oracle {

/// forEachOf (core/parallel.h), which pauses between some of them where work may pause.
template <class Work>
void forEachPausing(std::size_t count, std::size_t together, const Work& work) {
    const std::size_t batch =
        pauseHook() == nullptr ? count : 2 * together * std::max(1u, std::thread::hardware_concurrency());
    for (std::size_t first = 0; first < count; first += batch) {
        forEachOf(std::min(batch, count - first), together, [&](std::size_t i) { work(first + i); });
        pausePoint();
    }
}

}  // namespace timeshade::oracle
