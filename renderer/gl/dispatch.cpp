#include "gl/dispatch.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <glad/gl.h>

#include "core/error.h"
#include "core/pause.h"
#include "gl/first_use.h"
#include "gl/pause_point.h"
#include "gl/piece_length.h"

namespace timeshade::gl {

namespace {

constexpr std::size_t firstPiece = 16;  // groups

/// Most work groups along an axis. Tests lower that of the first by TIMESHADE_TEST_WORK_GROUPS.
std::size_t limitOf(GLuint axis) {
    GLint limit = 0;
    glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, axis, &limit);
    static const char* const lowered = std::getenv("TIMESHADE_TEST_WORK_GROUPS");
    if (lowered != nullptr && axis == 0) limit = std::min(limit, std::max(1, std::atoi(lowered)));
    return static_cast<std::size_t>(std::max(limit, 1));
}

/// The program in use, and where it wants to be told which groups a piece has.
struct Told {
    GLuint program = 0;
    GLint location = -1;

    Told() {
        GLint current = 0;
        glGetIntegerv(GL_CURRENT_PROGRAM, &current);
        program = static_cast<GLuint>(current);
        location = glGetUniformLocation(program, "dispatchedGroups");
    }
    void operator()(std::size_t before, std::size_t all) const {
        glProgramUniform2ui(program, location, static_cast<GLuint>(before), static_cast<GLuint>(all));
    }
};

/// Each in one row: groups that fill up a second one would be the next piece's.
void dispatchInPieces(const Told& tell, std::size_t groups, std::size_t longest) {
    announceFirstUse();
    glFinish();
    PieceLength length(firstPiece, longest);
    for (std::size_t before = 0; before < groups;) {
        const std::size_t count = std::min(length.next(), groups - before);
        tell(before, groups);
        glDispatchCompute(static_cast<GLuint>(count), 1, 1);
        glFinish();
        length.wasDone();
        before += count;
        timeshade::pausePoint();
    }
}

}  // namespace

void dispatch(std::size_t groups) {
    if (groups == 0) return;
    const std::size_t longest = limitOf(0), rows = groupsFor(groups, longest);
    if (rows > limitOf(1))
        throw LimitError(fmt::format(
            "{} work groups are needed, this device's GL_MAX_COMPUTE_WORK_GROUP_COUNT is {} x {}: lower --map", groups,
            longest, limitOf(1)));
    const Told tell;
    if (pauseHook() != nullptr && tell.location >= 0) return dispatchInPieces(tell, groups, longest);
    const std::size_t columns = groupsFor(groups, rows);
    tell(0, columns * rows);
    glDispatchCompute(static_cast<GLuint>(columns), static_cast<GLuint>(rows), 1);
    pausePoint();
}

}  // namespace timeshade::gl
