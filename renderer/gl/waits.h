#pragma once

#include <cstdint>

namespace timeshade::gl {

/// Says that the caller is about to wait until the device has done what it was told: a readback, or a query's result
/// that is not there yet. Everything in this program that waits says so, but for the clock of a software renderer.
void countWait();

/// How often that has been, by all contexts of this process.
std::uint64_t waitsSoFar();

}  // namespace timeshade::gl
