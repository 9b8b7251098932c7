#include "measure/display_encoding.h"

#include <algorithm>
#include <cmath>

#include "shared/display_curve.shared.h"

namespace timeshade {

namespace {

float curveOf(ToneMap toneMap, float value) {
    switch (toneMap) {
    case ToneMap::Filmic: return shared::filmicCurve(value);
    case ToneMap::Reinhard: return shared::reinhardCurve(value);
    case ToneMap::Linear: break;
    }
    return std::clamp(value, 0.0f, 1.0f);
}

}  // namespace

DisplayImage displayed(const LinearImage& image, const DisplayLook& look) {
    const float exposure = static_cast<float>(std::exp2(look.exposure));
    DisplayImage out{image.width, image.height, {}};
    out.rgb.reserve(image.rgb.size());
    for (const float value : image.rgb) {
        const float shown = curveOf(look.toneMap, exposure * value);
        out.rgb.push_back(static_cast<std::uint8_t>(std::lround(255.0f * shared::encodeSrgb(shown))));
    }
    return out;
}

}  // namespace timeshade
