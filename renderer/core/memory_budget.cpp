#include "core/memory_budget.h"

#include <unistd.h>
#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade {

namespace {

double mebibytes(double bytes) { return bytes / (1024.0 * 1024.0); }

}  // namespace

void MemoryBudget::take(std::uint64_t times, std::uint64_t each, const std::string& what) {
    if (each != 0 && times > left() / each)
        throw Error(fmt::format(
            "no room for {} ({:.1f} MiB): of the {:.1f} MiB that a scene may take (--memory-limit) {:.1f} are left",
            what, mebibytes(static_cast<double>(times) * static_cast<double>(each)),
            mebibytes(static_cast<double>(limit_)), mebibytes(static_cast<double>(left()))));
    used_ += times * each;
}

std::uint64_t quarterOfMemory() {
    const long pages = sysconf(_SC_PHYS_PAGES), bytes = sysconf(_SC_PAGESIZE);
    constexpr std::uint64_t least = std::uint64_t{256} << 20;
    if (pages <= 0 || bytes <= 0) return least;
    return std::max(least, static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(bytes) / 4);
}

}  // namespace timeshade
