#pragma once

namespace timeshade {

/// What one value of a technique averages over: its value for camera sample (pixel, k) estimates the visibility of the
/// light, averaged over this, *restricted to the surface that the sample sees*. The receiver is followed as a point of
/// its triangle (barycentrics fixed) over the footprint's time, and over the pixel's area on that surface. A mean over
/// time is weighted by the shutter's response (FrameBlock::response): the integral of w lit over that of w, over the
/// stratum or the shutter. Both errors of a technique are judged by it: see docs/numerics.md.
struct Footprint {
    enum class Time {
        Instant,  ///< the sample's own time
        Stratum,  ///< the stratum of the shutter that the sample's time lies in
        Shutter   ///< the whole shutter
    };
    enum class Space {
        Point,        ///< the receiver itself
        PixelSurface  ///< what the pixel's area sees of the surface that the sample sees
    };
    Time time = Time::Instant;
    Space space = Space::Point;
    /// Width of a blur, in texels of the light's map at the receiver's depth, that is no part of the estimate but an
    /// approximation of the technique's own (percentage-closer filtering, a variance test): not truth. 0: none.
    double filterTexels = 0.0;

    /// Of a filter of (2 radius + 1) x (2 radius + 1) tests; 0: a single one.
    static double filterOf(int radius) { return radius > 0 ? 2.0 * radius + 1.0 : 0.0; }
    /// The truth is then a single test, 0 or 1: a blur is no part of the truth.
    bool isInstantAtPoint() const { return time == Time::Instant && space == Space::Point; }
    /// Each value is then 0 or 1, and can be right or wrong.
    bool isBinary() const { return isInstantAtPoint() && filterTexels == 0.0; }
};

}  // namespace timeshade
