#pragma once

namespace timeshade {

enum class ShutterPosition { Start, Centre, End };

/// How much the light of each instant counts in the picture: the shutter's response w(u) of equation 2.1 in Palmér's
/// thesis (shaders/shared/shutter_response.shared.h).
enum class ShutterResponse {
    Box,      ///< all instants alike
    Tent,     ///< rises evenly to the middle of the shutter and falls to its end
    Gaussian  ///< about the middle of the shutter, cut at its ends
};

/// When the shutter is open; terms and units as in Blender. And how it responds while it is.
struct Shutter {
    double framesPerSecond = 24.0;  ///< > 0
    double length = 0.5;            ///< frames during which the shutter is open, >= 0 (0.5 is 180 degrees)
    ShutterPosition position = ShutterPosition::Start;  ///< position of the frame's instant in the open interval
    ShutterResponse response = ShutterResponse::Box;
    double width = 1.0 / 6.0;  ///< standard deviation of the Gaussian, a share of the shutter; of others no matter

    static constexpr double leastWidth = 0.05, mostWidth = 2.0;

    /// Scene time, in seconds, of the opening (u = 0) and the closing (u = 1) of the given frame.
    double openSeconds(double frame) const { return (frame - offset()) / framesPerSecond; }
    double closeSeconds(double frame) const { return (frame - offset() + length) / framesPerSecond; }

    bool operator==(const Shutter&) const = default;

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
