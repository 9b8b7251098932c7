#pragma once

namespace timeshade {

/// From exposed radiance to [0, 1], before the sRGB encoding.
enum class ToneMap {
    Filmic,    ///< a curve with a toe and a shoulder (shaders/shared/display_curve.shared.h)
    Reinhard,  ///< x / (1 + x): nothing is ever clipped
    Linear     ///< as it is; what is above 1 is clipped
};

/// How radiance is shown in pictures, videos and the window. Not in EXR files.
struct DisplayLook {
    double exposure = 0.0;  ///< stops above the scene's own exposure, within leastExposure .. mostExposure
    ToneMap toneMap = ToneMap::Filmic;
    bool operator==(const DisplayLook&) const = default;

    static constexpr double leastExposure = -16.0, mostExposure = 16.0;
};

}  // namespace timeshade
