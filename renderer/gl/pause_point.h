#pragma once

#include <functional>

namespace timeshade::gl {

/// As timeshade::pausePoint, between commands to OpenGL: waits for those so far, so that a slice of work is over when
/// it seems to be. Whoever pauses restores all state that it changes.
void pausePoint();

/// Draws into the viewport: at once, or where work may pause, in bands of rows with a pause point after each. What is
/// drawn is the same. `draw` must have no effect outside the fragments that it draws.
void drawInBands(const std::function<void()>& draw);

}  // namespace timeshade::gl
