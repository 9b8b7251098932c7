#include "compare/compared_side.h"

#include <fmt/format.h>

#include "core/error.h"
#include "options/number_list.h"
#include "plan/frame_request.h"

namespace timeshade {

namespace {

int samplesOf(const std::string& text, const std::string& value) {
    const auto samples = numbersIn<int>(value, 1);
    if (!samples || samples->front() < 1 || samples->front() > maximumSamplesPerPixel)
        throw UsageError(fmt::format("--compare {}: spp={} given, expected a whole number from 1 to {}", text, value,
                                     maximumSamplesPerPixel));
    return samples->front();
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
