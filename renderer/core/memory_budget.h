#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace timeshade {

/// Bytes that one piece of work may take, counted before they are allocated. What is counted is never given back: a
/// limit on a sum, not on a peak.
class MemoryBudget {
  public:
    /// Without a limit.
    MemoryBudget() = default;
    explicit MemoryBudget(std::uint64_t limit) : limit_(limit) {}

    /// Counts `each` bytes `times` times over. Throws Error, in one line that names `what` and the limit, where that is
    /// more than what is left; nothing is counted then.
    void take(std::uint64_t times, std::uint64_t each, const std::string& what);

    std::uint64_t left() const { return limit_ - used_; }

  private:
    std::uint64_t limit_ = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t used_ = 0;
};

/// A quarter of the machine's memory.
std::uint64_t quarterOfMemory();

}  // namespace timeshade
