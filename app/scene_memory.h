#pragma once

#include <cstdint>

namespace timeshade {

/// Bytes that a scene of a file may take, of all scenes that are opened from now on. The process's, whatever the
/// command: a quarter of the machine's memory until it is set.
std::uint64_t sceneMemoryLimit();
void limitSceneMemory(std::uint64_t bytes);

}  // namespace timeshade
