// Programs are cached for as long as they are in use, and not longer.
#include <gtest/gtest.h>

#include "gl/program_cache.h"
#include "support/gl_environment.h"

namespace timeshade {
namespace {

gl::ProgramDescription scanStep(const char* step) {
    return {.label = "scan", .defines = {{"SCAN_STEP", step}}, .compute = "passes/list_scan.comp"};
}

TEST(ProgramCache, DropsTheLeastRecentlyUsed) {
    gl::ProgramCache cache;
    const GLuint first = cache.get(scanStep("0")).name(), second = cache.get(scanStep("1")).name(),
                 third = cache.get(scanStep("2")).name();
    EXPECT_EQ(cache.get(scanStep("0")).name(), first) << "built twice";
    cache.keepNewest(3);
    EXPECT_EQ(cache.size(), 3u);
    cache.keepNewest(2);
    EXPECT_EQ(cache.size(), 2u);
    EXPECT_TRUE(glIsProgram(first) && glIsProgram(third));
    EXPECT_FALSE(glIsProgram(second));
    EXPECT_EQ(cache.get(scanStep("0")).name(), first);
    EXPECT_TRUE(glIsProgram(cache.get(scanStep("1")).name()));
    EXPECT_EQ(cache.size(), 3u);
}

}  // namespace
}  // namespace timeshade
