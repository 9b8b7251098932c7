#include "gl/pause_point.h"

#include <algorithm>
#include <array>
#include <chrono>

#include <glad/gl.h>

#include "core/pause.h"
#include "core/work_part.h"

namespace timeshade::gl {

namespace {

constexpr int firstBand = 16;            // rows; always even, so that no quad of fragments is cut
constexpr double bandMilliseconds = 15;  // that a band should take
constexpr double growth = 4.0;           // of the bands, at most, from one to the next

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
    using Clock = std::chrono::steady_clock;
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    glFinish();
    const Scissor scissor;
    int rows = firstBand;
    for (int from = 0, to = 0; from < viewport[3]; from = to) {
        const auto begin = Clock::now();
        to = std::min(from + rows, viewport[3]);
        const WorkPart part(double(from) / viewport[3], double(to) / viewport[3]);
        glScissor(viewport[0], viewport[1] + from, viewport[2], to - from);
        draw();
        glFinish();
        const double taken = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
        timeshade::pausePoint();
        const double factor = std::min(bandMilliseconds / std::max(taken, 1e-3), growth);
        rows = std::max(2, 2 * static_cast<int>(0.5 * rows * factor));
    }
}

}  // namespace timeshade::gl
