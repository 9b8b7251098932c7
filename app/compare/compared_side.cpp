#include "compare/compared_side.h"

#include <charconv>

#include <fmt/format.h>

#include "core/error.h"
#include "plan/frame_request.h"

namespace timeshade {

namespace {

int samplesOf(const std::string& text, const std::string& value) {
    int samples = 0;
    const char* end = value.data() + value.size();
    const auto [rest, failure] = std::from_chars(value.data(), end, samples);
    if (failure != std::errc{} || rest != end || samples < 1 || samples > maximumSamplesPerPixel)
        throw UsageError(fmt::format("--compare {}: spp={} given, expected a whole number from 1 to {}", text, value,
                                     maximumSamplesPerPixel));
    return samples;
}

}  // namespace

ComparedSide ComparedSide::of(const std::string& text) {
    ComparedSide side;
    if (text == truthName) {
        side.kind = Kind::Truth;
        return side;
    }
    if (text.ends_with(".png") || text.ends_with(".exr")) {
        side.kind = Kind::File;
        side.path = text;
        return side;
    }
    side.variant = TechniqueVariant::of(text);
    std::erase_if(side.variant.settings, [&](const auto& setting) {
        if (setting.first == "spp") side.samplesPerPixel = samplesOf(text, setting.second);
        return setting.first == "spp";
    });
    return side;
}

std::string truthLabel(int samples) { return fmt::format("Ground truth, {} spp", samples); }

}  // namespace timeshade
