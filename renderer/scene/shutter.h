#pragma once

namespace timeshade {

enum class ShutterPosition { Start, Centre, End };

/// When the shutter is open; terms and units as in Blender.
struct Shutter {
    double framesPerSecond = 24.0;  ///< > 0
    double length = 0.5;            ///< frames during which the shutter is open, >= 0 (0.5 is 180 degrees)
    ShutterPosition position = ShutterPosition::Start;  ///< position of the frame's instant in the open interval

    /// Scene time, in seconds, of the opening (u = 0) and the closing (u = 1) of the given frame.
    double openSeconds(double frame) const { return (frame - offset()) / framesPerSecond; }
    double closeSeconds(double frame) const { return (frame - offset() + length) / framesPerSecond; }

  private:
    double offset() const {
        switch (position) {
        case ShutterPosition::Start: return 0.0;
        case ShutterPosition::Centre: return 0.5 * length;
        case ShutterPosition::End: return length;
        }
        return 0.0;
    }
};

}  // namespace timeshade
