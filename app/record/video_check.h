#pragma once

namespace timeshade {

/// Reads a finished video back with the program ffprobe: every packet of its one stream, from the first to the last.
/// `descriptor` is the open file. Throws Error that says what was found where it cannot be read or does not hold
/// `frames` frames that last as long as they should at `framesPerSecond`.
void requireFinishedVideo(int descriptor, int frames, double framesPerSecond);

/// Throws Error where ffprobe cannot be started. To be called before anything is drawn.
void requireVideoCheck(int descriptor);

}  // namespace timeshade
