#include "scene_memory.h"

#include "core/memory_budget.h"

namespace timeshade {

namespace {
std::uint64_t limit = quarterOfMemory();
}  // namespace

std::uint64_t sceneMemoryLimit() { return limit; }
void limitSceneMemory(std::uint64_t bytes) { limit = bytes; }

}  // namespace timeshade
