#include "core/check.h"

#include <cstdio>
#include <cstdlib>

namespace timeshade::detail {

void failCheck(const char* file, int line, const char* expression, const std::string& values) {
    std::fprintf(stderr, "%s:%d: check failed: %s (%s)\n", file, line, expression, values.c_str());
    std::fflush(stderr);
    std::abort();
}

}  // namespace timeshade::detail
