#include "gl/dispatch.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <glad/gl.h>

#include "core/error.h"
#include "gl/pause_point.h"

namespace timeshade::gl {

namespace {

/// Most work groups along an axis. Tests lower that of the first by TIMESHADE_TEST_WORK_GROUPS.
std::size_t limitOf(GLuint axis) {
    GLint limit = 0;
    glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, axis, &limit);
    static const char* const lowered = std::getenv("TIMESHADE_TEST_WORK_GROUPS");
    if (lowered != nullptr && axis == 0) limit = std::min(limit, std::max(1, std::atoi(lowered)));
    return static_cast<std::size_t>(std::max(limit, 1));
}

}  // namespace

void dispatch(std::size_t groups) {
    if (groups == 0) return;
    const std::size_t longest = limitOf(0), rows = groupsFor(groups, longest);
    if (rows > limitOf(1))
        throw LimitError(fmt::format(
            "{} work groups are needed, this device's GL_MAX_COMPUTE_WORK_GROUP_COUNT is {} x {}: lower --map", groups,
            longest, limitOf(1)));
    glDispatchCompute(static_cast<GLuint>(groupsFor(groups, rows)), static_cast<GLuint>(rows), 1);
    pausePoint();
}

}  // namespace timeshade::gl
