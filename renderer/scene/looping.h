#pragma once

namespace timeshade {

class Scene;

/// What comes before a clip's start and after its end.
enum class Looping {
    Auto,  ///< a clip whose end joins its start repeats; any other is held at both ends
    On,    ///< every clip repeats
    Off    ///< every clip is held at both ends
};

/// Scene time, in seconds, of the two ends of a shutter.
struct ShutterTimes {
    double open = 0.0, close = 0.0;
};

/// The times at which the scene is evaluated for a shutter, open <= close. Where a repeated clip jumps back to its
/// start inside the shutter, the jump is moved to the shutter's nearer end: both times are clamped to the repetition in
/// which the middle of the shutter lies.
ShutterTimes loopedTimes(const Scene& scene, Looping looping, const ShutterTimes& times);

}  // namespace timeshade
