#include "measure/display_encoding.h"

#include <algorithm>
#include <cmath>

#include "shared/display_curve.shared.h"

namespace timeshade {

DisplayImage displayed(const LinearImage& image, bool toneMapped) {
    DisplayImage out{image.width, image.height, {}};
    out.rgb.reserve(image.rgb.size());
    for (const float value : image.rgb) {
        const float shown = toneMapped ? shared::filmicCurve(value) : std::clamp(value, 0.0f, 1.0f);
        out.rgb.push_back(static_cast<std::uint8_t>(std::lround(255.0f * shared::encodeSrgb(shown))));
    }
    return out;
}

}  // namespace timeshade
