#include "gl/pause_point.h"

#include <algorithm>
#include <array>

#include <glad/gl.h>

#include "core/pause.h"
#include "core/work_part.h"
#include "gl/first_use.h"
#include "gl/piece_length.h"

namespace timeshade::gl {

namespace {

constexpr std::size_t firstBand = 8;  // pairs of rows: no quad of fragments is cut

/// Ends with the bands, however they end.
struct Scissor {
    Scissor() { glEnable(GL_SCISSOR_TEST); }
    ~Scissor() { glDisable(GL_SCISSOR_TEST); }
    Scissor(const Scissor&) = delete;
    Scissor& operator=(const Scissor&) = delete;
};

}  // namespace

void pausePoint() {
    if (pauseHook() == nullptr) return;
    glFinish();
    timeshade::pausePoint();
}

void drawInBands(const std::function<void()>& draw) {
    if (pauseHook() == nullptr) return draw();
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    announceFirstUse();
    glFinish();
    const Scissor scissor;
    PieceLength pairs(firstBand, static_cast<std::size_t>(viewport[3]) / 2 + 1);
    for (int from = 0, to = 0; from < viewport[3]; from = to) {
        to = std::min(from + 2 * static_cast<int>(pairs.next()), viewport[3]);
        const WorkPart part(double(from) / viewport[3], double(to) / viewport[3]);
        glScissor(viewport[0], viewport[1] + from, viewport[2], to - from);
        draw();
        glFinish();
        pairs.wasDone();
        timeshade::pausePoint();
    }
}

}  // namespace timeshade::gl
