#include "gl/waits.h"

#include <atomic>

namespace timeshade::gl {

namespace {

std::atomic<std::uint64_t> waits{0};

}  // namespace

void countWait() { ++waits; }

std::uint64_t waitsSoFar() { return waits; }

}  // namespace timeshade::gl
